#ifndef OSGWATERREFLECT_TESTS_SUPPORT_COPIEDVIEW_H
#define OSGWATERREFLECT_TESTS_SUPPORT_COPIEDVIEW_H

#include "HarbourWindow.h"

#include <osgWaterReflect/capture/FrameCopy.h>

#include <osg/Drawable>
#include <osgUtil/CullVisitor>

#include <functional>
#include <map>
#include <memory>
#include <utility>

/// A capture's images, and the copy into them, for one camera of one view.
struct CopiedCapture
{
    CopiedCapture(int width, int height, GLint colourFormat);

    void release();

    osg::ref_ptr<osgWaterReflect::FrameCopy> copy;
    osg::ref_ptr<osg::Texture2D> colour;
    osg::ref_ptr<osg::Texture2D> windowZ;
    osg::ref_ptr<osg::Camera> camera;
    osg::ref_ptr<osg::RefMatrix> frameProjection; ///< once drawn: as OSG has fitted it
};

/// Copies the frame of every view that culls its node.
class CopyFrame : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override;

    /// The only one: fails the running test where there are more, or none.
    CopiedCapture& one();

    bool enabled = true;
    osg::Vec2i origin{0, 0}; ///< [pixels] of the frame in the capture
    osg::Vec2i least{0, 0};  ///< [pixels] size of a capture
    double scale = 1.0;      ///< of the capture's pixels over the frame's
    GLint colourFormat = GL_RGBA8;
    osg::ref_ptr<osg::RefMatrix> projection; ///< null: the frame's own

    /// Called in the cull, when a frame's copy is required.
    std::function<void(CopiedCapture&, osgUtil::CullVisitor&)> arranged = [](auto&, auto&) {};

    std::map<std::pair<osg::NodeVisitor*, osg::Camera*>, std::unique_ptr<CopiedCapture>> captures;
};

/// The node whose cull copies.
osg::ref_ptr<osg::Group> createCopier(CopyFrame& copy);

/// Draws nothing, but reads what has been drawn before the copy.
class ReadFrame : public osg::Drawable
{
public:
    ReadFrame();
    META_Object(test, ReadFrame)
    ReadFrame(const ReadFrame& rhs, const osg::CopyOp& copyop) : osg::Drawable(rhs, copyop) {}

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

    mutable osg::ref_ptr<osg::Image> colour;
    mutable osg::ref_ptr<osg::Image> windowZ;
};

/// A view of the harbour whose frame is copied.
struct CopiedView : HarbourWindow
{
    CopiedView();

    osg::State& state() { return *camera().getGraphicsContext()->getState(); }

    /// Renders to textures in place of the window.
    void renderTo(GLint colourFormat, int samples = 0);

    /// What the only capture holds.
    osg::ref_ptr<osg::Image> copiedColour();
    osg::ref_ptr<osg::Image> copiedWindowZ();

    /// A texture's image, of floats. The format is GL_RGBA or GL_DEPTH_COMPONENT.
    osg::ref_ptr<osg::Image> read(osg::Texture2D& texture, GLenum format);

    osg::ref_ptr<CopyFrame> copy;
    osg::ref_ptr<osg::Group> copier;
    osg::ref_ptr<ReadFrame> reader;

private:
    void refuseCoverageSamples();
};

/// Something that is not to be copied, drawn after the copy: nearer than all of the harbour.
osg::ref_ptr<osg::Node> createCurtain(int bin);

/// A program that draws one colour, that of a uniform.
osg::ref_ptr<osg::Program> createColourProgram(const std::string& uniform);

#endif
