#ifndef OSGWATERREFLECT_CAPTURE_FRAMEIMAGES_H
#define OSGWATERREFLECT_CAPTURE_FRAMEIMAGES_H

#include <osg/FrameBufferObject>
#include <osg/Texture2D>
#include <osg/Viewport>

namespace osgWaterReflect
{

/// Copies of what a framebuffer holds while it is being drawn to, samples resolved.
///
/// | image   | format                      | size         |
/// |---------|-----------------------------|--------------|
/// | colour  | as asked for                | the viewport |
/// | windowZ | as the framebuffer's depth  | the same     |
class FrameImages : public osg::Referenced
{
public:
    FrameImages();

    /// Copies the part of the bound draw framebuffer that a viewport shows, drawing what is drawn
    /// so far. Binds other framebuffers and textures; to be called within a RenderStateGuard. False
    /// where there is no depth to copy.
    bool copy(osg::State& state, const osg::Viewport& viewport, GLint colourFormat);

    osg::Texture2D* colour() const { return _colour.get(); }
    osg::Texture2D* windowZ() const { return _windowZ.get(); }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

private:
    void allocate(int width, int height, GLint colourFormat, GLint depthFormat);

    osg::ref_ptr<osg::Texture2D> _colour;
    osg::ref_ptr<osg::Texture2D> _windowZ;
    osg::ref_ptr<osg::FrameBufferObject> _resolved; // of both
};

} // namespace osgWaterReflect

#endif
