#ifndef OSGWATERREFLECT_OFFSCREEN_OFFSCREENCONTEXT_H
#define OSGWATERREFLECT_OFFSCREEN_OFFSCREENCONTEXT_H

#include <osg/GraphicsContext>

namespace osgWaterReflect
{

/// A graphics context that needs no display, with a colour, depth and stencil buffer of a size
/// [pixels]. Null, with a message, where none can be made.
///
/// Two libraries define it, of which a program links one: osgWaterReflectOffscreenOSMesa renders
/// in software into memory, and a program that links it cannot open windows;
/// osgWaterReflectOffscreenEGL uses the system's OpenGL, a GPU too, beside windows.
osg::ref_ptr<osg::GraphicsContext> createOffscreenContext(int width, int height);

/// What both back ends share: a context whose size never changes and that belongs to no window.
class OffscreenContext : public osg::GraphicsContext
{
public:
    OffscreenContext(int width, int height);

    bool realizeImplementation() override { return _realized = valid(); }
    bool isRealizedImplementation() const override { return _realized && valid(); }
    bool makeContextCurrentImplementation(osg::GraphicsContext*) override
    {
        return makeCurrentImplementation();
    }
    void bindPBufferToTextureImplementation(GLenum) override {}
    void swapBuffersImplementation() override {}

private:
    bool _realized = false;
};

} // namespace osgWaterReflect

#endif
