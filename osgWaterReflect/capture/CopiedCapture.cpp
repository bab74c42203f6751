#include "CopiedCapture.h"

#include "../Transforms.h"

using namespace osgWaterReflect;

CopiedCapture::CopiedCapture() : Capture(CAMERA_NAME), _scene(*_stage), _copy(new FrameCopy) {}

void CopiedCapture::take(const CulledView& view, const CaptureSize& size)
{
    if (size.whole() == size.view)
        drawNothing(view);
    else
        drawBand(view, size);
    allocate(view, size);
    setMatrices(view.eyeFromWorld, glm::dmat4(1.0), *_projection, fromOsg(*_projection));
    drawBefore(view);

    const osg::ref_ptr<osg::Viewport> place =
        new osg::Viewport(size.band.left, size.band.bottom, size.view.x, size.view.y);
    _copy->arrange(view, *_camera, *place, *_projection);
}

void CopiedCapture::drawBand(const CulledView&, const CaptureSize& size)
{
    _scene.fitTo(size);
    _scene.finish();
    _projection = &_scene.projection();
}

// Its stage is there for those who look into a frame.
void CopiedCapture::drawNothing(const CulledView& view)
{
    _projection = new osg::RefMatrix(*view.fittedProjection);
    _stage->reset();
    _stage->setInitialViewMatrix(new osg::RefMatrix(view.eyeFromWorld));
    _stage->setColorMask(view.stage->getColorMask());
    _stage->setClearColor(view.stage->getClearColor());
    _stage->setClearMask(0);
    _stage->sort();
}

void CopiedCapture::releaseGLObjects(osg::State* state) const
{
    _copy->releaseGLObjects(state);
    Capture::releaseGLObjects(state);
}

void CopiedCapture::resizeGLObjectBuffers(unsigned int maxSize)
{
    _copy->resizeGLObjectBuffers(maxSize);
    Capture::resizeGLObjectBuffers(maxSize);
}
