#ifndef OSGWATERREFLECT_IMAGES_SKYIMAGE_H
#define OSGWATERREFLECT_IMAGES_SKYIMAGE_H

#include "../capture/Capture.h"
#include "../passes/ImagePass.h"

#include <osg/Program>

#include <glm/vec3.hpp>

namespace osgWaterReflect
{

/// The sky that a capture shows, where things hide it, too: for rays that meet nothing behind them.
///
/// | image | format  | a texel holds                                            | side of its block
/// [px] |
/// |-------|---------|----------------------------------------------------------|------------------------|
/// | sky   | RGBA32F | the colour of the background that is seen nearest above  | 16 | |       | |
/// its centre, and 1; all 0 where there is none             |                        |
///
/// Above is where a direction's vanishing point lies: the still water's normal, so that a camera
/// may roll. The background is looked for at every fourth pixel.
class SkyImage : public GLObjects
{
public:
    SkyImage();

    /// Computes it as soon as the capture is rendered.
    ///   upEye  of unit length, in the view's eye space
    void compute(const Capture& capture, const glm::dvec3& upEye);

    /// What computes it, for those who compile ahead.
    static osg::ref_ptr<osg::Program> program();

    osg::Texture2D* image() const { return _pass->image(); }

    void releaseGLObjects(osg::State* state) const override { _pass->releaseGLObjects(state); }
    void resizeGLObjectBuffers(unsigned int maxSize) override
    {
        _pass->resizeGLObjectBuffers(maxSize);
    }

private:
    const osg::ref_ptr<ImagePass> _pass;
};

} // namespace osgWaterReflect

#endif
