#include "CapturedScene.h"

#include "../Transforms.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;

namespace
{

// Distances along the view [eye units].
struct NearFar
{
    double near;
    double far; // may be infinite
};

NearFar nearFarOf(const osg::Matrixd& projection)
{
    const double a = projection(2, 2);
    const double b = projection(3, 2);
    if (projection(2, 3) == 0.0) return {(b + 1.0) / a, (b - 1.0) / a}; // orthographic
    return {std::abs(b / (a - 1.0)), std::abs(b / (a + 1.0))};
}

void setNearFar(osg::Matrixd& projection, const NearFar& range)
{
    const auto [near, far] = range;
    if (projection(2, 3) == 0.0)
    {
        projection(2, 2) = -2.0 / (far - near);
        projection(3, 2) = -(far + near) / (far - near);
        return;
    }
    const double ratio = near / far;
    projection(2, 2) = -(1.0 + ratio) / (1.0 - ratio);
    projection(3, 2) = -2.0 * near / (1.0 - ratio);
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
    NearFar range = nearFarOf(*view.fittedProjection);
    if (_visitor->isFitted())
    {
        const NearFar beyond = nearFarOf(*_projection);
        range = {std::min(range.near, beyond.near), std::max(range.far, beyond.far)};
    }
    setNearFar(*_projection, range);
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
