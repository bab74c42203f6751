#include "CullView.h"

using namespace osgwaterbench;

namespace
{

// [m] A wide range: OSG fits it to what is in view.
const double Z_NEAR = 0.1;
const double Z_FAR = 1000.0;

} // namespace

CullView::CullView(osg::Node& scene, const glm::ivec2& size)
{
    _view->setDefaults();
    _view->setFrameStamp(_frameStamp);
    _view->setViewport(0, 0, size.x, size.y);
    _view->setSceneData(&scene);
    scene.getBound();
}

void CullView::setEye(const osg::Vec3d& eye, const osg::Vec3d& centre, double fovyDegrees)
{
    const osg::Viewport& viewport = *_view->getViewport();
    _view->setProjectionMatrixAsPerspective(fovyDegrees, viewport.aspectRatio(), Z_NEAR, Z_FAR);
    _view->setViewMatrixAsLookAt(eye, centre, osg::Vec3d(0, 0, 1));
}

void CullView::cull(double time)
{
    _frameStamp->setFrameNumber(_frameStamp->getFrameNumber() + 1);
    _frameStamp->setReferenceTime(time);
    _frameStamp->setSimulationTime(time);
    _view->cull();
}
