#include "MirroredCapture.h"

#include "../Transforms.h"
#include "../shaders/Bindings.h"

using namespace osgWaterReflect;

MirroredCapture::MirroredCapture() :
    Capture(MIRROR_CAMERA_NAME), _scene(*_stage),
    _straightened(new ImagePass(STRAIGHTEN, GL_R32F, GL_RED))
{
    _straightened->setInput(0, bindings::OBLIQUE_WINDOW_Z, _windowZ);
}

// The scene is culled, and near and far are fitted, with the projection as it would be without the
// floor: OpenSceneGraph's clamp would move an oblique near plane, and so would its culling a far
// plane. What has been culled refers to the matrix, and is drawn with what it is in the end.
void MirroredCapture::draw(const CulledView& view, const CaptureEye& eye, const CaptureSize& size,
                           double amplitude)
{
    _scene.cull(view, eye, NdcExtent());
    const glm::dmat4 clipFromEye = _scene.fitTo(size);
    const ObliqueProjection oblique = obliqueProjection(clipFromEye, *eye.floor, amplitude);
    _scene.projection().set(toOsg(oblique.clipFromEye));
    _scene.finish();
    allocate(view, size);
    setMatrices(*_stage->getInitialViewMatrix(), eye.eyeFromViewEye, _scene.projection(),
                clipFromEye);
    drawBefore(view);
    straighten(oblique.straightened);
}

void MirroredCapture::straighten(const glm::dvec4& straightened)
{
    bindings::set(_straightened->stateSet(), bindings::WINDOW_Z_FROM_OBLIQUE,
                  osg::Vec4(straightened.x / size().x, straightened.y / size().y, straightened.z,
                            straightened.w));
    _straightened->require(*_stage, size(), capacity());
}

void MirroredCapture::releaseGLObjects(osg::State* state) const
{
    _straightened->releaseGLObjects(state);
    Capture::releaseGLObjects(state);
}

void MirroredCapture::resizeGLObjectBuffers(unsigned int maxSize)
{
    _straightened->resizeGLObjectBuffers(maxSize);
    Capture::resizeGLObjectBuffers(maxSize);
}
