#include "CapturedScene.h"

#include "../Transforms.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;

namespace
{

// Distance before the eye [eye units] at which a projection has an ndc z; infinite for the far
// plane of an endless one.
double distanceOf(const osg::Matrixd& projection, double ndcZ)
{
    const double z =
        (ndcZ * projection(3, 3) - projection(3, 2)) / (projection(2, 2) - ndcZ * projection(2, 3));
    return std::isfinite(z) ? -z : std::numeric_limits<double>::infinity();
}

double ndcZOf(const osg::Matrixd& projection, double distance)
{
    if (std::isinf(distance)) return projection(2, 2) / projection(2, 3);
    return (projection(3, 2) - distance * projection(2, 2)) /
           (projection(3, 3) - distance * projection(2, 3));
}

// Nothing changes but z, in any kind of projection.
void setNearFar(osg::Matrixd& projection, double nearest, double farthest)
{
    const double first = ndcZOf(projection, nearest);
    const double last = ndcZOf(projection, farthest);
    const double scale = 2.0 / (last - first);
    for (int row = 0; row < 4; ++row)
        projection(row, 2) =
            scale * (projection(row, 2) - 0.5 * (first + last) * projection(row, 3));
}

} // namespace

void CapturedScene::cull(const CulledView& view, const CaptureEye& eye, const NdcExtent& extent,
                         Part part)
{
    const glm::ivec2 viewportSize = view.viewportSize();
    const GuardBand band = bandFor(extent, viewportSize, std::numeric_limits<int>::max());
    const glm::ivec2 size = widened(viewportSize, band);
    const osg::ref_ptr<osg::Viewport> wide = new osg::Viewport(0, 0, size.x, size.y);
    const SeenPyramid shown(NdcExtent(), eye.clipFromEye);
    _eye = eye;
    _projection = new osg::RefMatrix(toOsg(widened(eye.clipFromEye, viewportSize, band)));
    _visitor->cull(view, _stage, toOsg(eye.eyeFromViewEye), *_projection, *wide,
                   part == Part::BEYOND_VIEW ? &shown : nullptr);
    if (part == Part::BEYOND_VIEW) includeView(view);
    _reachesOut = !contains(NdcExtent(), extent);
    if (_reachesOut) _content.look(_stage, *_projection, eye.clipFromEye, part == Part::ALL);
}

// What the view shows is drawn, too.
void CapturedScene::includeView(const CulledView& view)
{
    double nearest = distanceOf(*view.fittedProjection, -1.0);
    double farthest = distanceOf(*view.fittedProjection, 1.0);
    if (_visitor->isFitted())
    {
        nearest = std::min(nearest, distanceOf(*_projection, -1.0));
        farthest = std::max(farthest, distanceOf(*_projection, 1.0));
    }
    setNearFar(*_projection, nearest, farthest);
}

glm::dmat4 CapturedScene::fitTo(const CaptureSize& size)
{
    glm::dmat4 wide = widened(_eye.clipFromEye, size.view, size.band);
    for (int column = 0; column < 4; ++column)
        wide[column][2] = (*_projection)(column, 2);
    if (_reachesOut) _content.keepSeenThrough(wide);
    _projection->set(toOsg(wide));
    return wide;
}
