#include "CapturedScene.h"

#include "../Transforms.h"

#include <limits>

using namespace osgWaterReflect;

void CapturedScene::cull(const CulledView& view, const CaptureEye& eye, const NdcExtent& extent)
{
    const glm::ivec2 viewportSize = view.viewportSize();
    const GuardBand band = bandFor(extent, viewportSize, std::numeric_limits<int>::max());
    const glm::ivec2 size = widened(viewportSize, band);
    const osg::ref_ptr<osg::Viewport> wide = new osg::Viewport(0, 0, size.x, size.y);
    _eye = eye;
    _culled = extent;
    _projection = new osg::RefMatrix(toOsg(widened(eye.clipFromEye, viewportSize, band)));
    _visitor->cull(view, _stage, toOsg(eye.eyeFromViewEye), *_projection, *wide);
}

NdcExtent CapturedScene::seen(bool skies, const NdcExtent& asked) const
{
    return StageContent{_stage, *_projection}.seenThrough(_eye.clipFromEye, skies, asked);
}

glm::dmat4 CapturedScene::fitTo(const CaptureSize& size)
{
    glm::dmat4 wide = widened(_eye.clipFromEye, size.view, size.band);
    for (int column = 0; column < 4; ++column)
        wide[column][2] = (*_projection)(column, 2);
    if (!contains(NdcExtent(), _culled)) StageContent{_stage, *_projection}.keepSeenThrough(wide);
    _projection->set(toOsg(wide));
    return wide;
}

void CapturedScene::keepBeyondView()
{
    StageContent{_stage, *_projection}.keepBeyond(_eye.clipFromEye);
}
