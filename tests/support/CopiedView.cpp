#include "CopiedView.h"

#include "Catch.h"
#include "Scenes.h"

#include <osg/GLExtensions>

#include <algorithm>

CopiedCapture::CopiedCapture(int width, int height, GLint colourFormat) :
    copy(new osgWaterReflect::FrameCopy), colour(new osg::Texture2D),
    windowZ(createWindowZTexture(width, height)), camera(new osg::Camera)
{
    colour->setInternalFormat(colourFormat);
    colour->setTextureSize(width, height);
    for (osg::Texture2D* texture : {colour.get(), windowZ.get()})
    {
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
        texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
        texture->setResizeNonPowerOfTwoHint(false);
    }
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewport(0, 0, width, height);
    camera->attach(osg::Camera::COLOR_BUFFER0, colour);
    camera->attach(osg::Camera::DEPTH_BUFFER, windowZ);
}

void CopiedCapture::release()
{
    copy->releaseGLObjects(nullptr);
    colour->releaseGLObjects(nullptr);
    windowZ->releaseGLObjects(nullptr);
}

void CopyFrame::operator()(osg::Node* node, osg::NodeVisitor* visitor)
{
    osgUtil::CullVisitor& view = *visitor->asCullVisitor();
    if (!enabled) return;
    const osg::Viewport& viewport = *view.getCurrentRenderStage()->getViewport();
    const osg::ref_ptr<osg::Viewport> place = new osg::Viewport(
        origin.x(), origin.y(), scale * viewport.width(), scale * viewport.height());
    std::unique_ptr<CopiedCapture>& capture = captures[{visitor, view.getCurrentCamera()}];
    if (!capture)
        capture = std::make_unique<CopiedCapture>(
            std::max(least.x(), int(place->width()) + 2 * origin.x()),
            std::max(least.y(), int(place->height()) + 2 * origin.y()), colourFormat);
    osg::RefMatrix& frame = *view.getProjectionMatrix();
    capture->frameProjection = &frame;
    osgWaterReflect::CulledView culled;
    culled.note(view);
    capture->copy->arrange(culled, *capture->camera, *place, projection ? *projection : frame);
    arranged(*capture, view);
    traverse(node, visitor);
}

CopiedCapture& CopyFrame::one()
{
    REQUIRE(captures.size() == 1);
    return *captures.begin()->second;
}

osg::ref_ptr<osg::Group> createCopier(CopyFrame& copy)
{
    osg::ref_ptr<osg::Group> node = new osg::Group;
    node->setCullCallback(&copy);
    node->setCullingActive(false);
    return node;
}

ReadFrame::ReadFrame()
{
    setCullingActive(false);
    setUseDisplayList(false);
    getOrCreateStateSet()->setRenderBinDetails(7, "RenderBin");
}

void ReadFrame::drawImplementation(osg::RenderInfo& renderInfo) const
{
    const osg::Viewport& part = *renderInfo.getState()->getCurrentViewport();
    colour = new osg::Image;
    windowZ = new osg::Image;
    colour->allocateImage(part.width(), part.height(), 1, GL_RGBA, GL_FLOAT);
    windowZ->allocateImage(part.width(), part.height(), 1, GL_LUMINANCE, GL_FLOAT);
    glReadPixels(part.x(), part.y(), part.width(), part.height(), GL_RGBA, GL_FLOAT,
                 colour->data());
    glReadPixels(part.x(), part.y(), part.width(), part.height(), GL_DEPTH_COMPONENT, GL_FLOAT,
                 windowZ->data());
}

CopiedView::CopiedView() : copy(new CopyFrame), copier(createCopier(*copy)), reader(new ReadFrame)
{
    // Errors of OpenGL are left for OffscreenView to find.
    state().setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
    camera().setPostDrawCallback(nullptr); // these captures are not the library's
}

// OSG looks functions up by name, and Mesa has this one without supporting it.
void CopiedView::refuseCoverageSamples()
{
    viewer().realize();
    camera().getGraphicsContext()->makeCurrent();
    state().get<osg::GLExtensions>()->glRenderbufferStorageMultisampleCoverageNV = nullptr;
    camera().getGraphicsContext()->releaseContext();
}

void CopiedView::renderTo(GLint colourFormat, int samples)
{
    camera().detach(osg::Camera::COLOR_BUFFER);
    camera().setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    osg::ref_ptr<osg::Texture2D> colour = new osg::Texture2D;
    colour->setTextureSize(WIDTH, HEIGHT);
    colour->setInternalFormat(colourFormat);
    colour->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    colour->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    camera().attach(osg::Camera::COLOR_BUFFER0, colour, 0, 0, false, samples);
    if (samples) refuseCoverageSamples();
    copy->colourFormat = colourFormat;
}

osg::ref_ptr<osg::Image> CopiedView::copiedColour()
{
    return read(*copy->one().colour, GL_RGBA);
}

osg::ref_ptr<osg::Image> CopiedView::copiedWindowZ()
{
    return read(*copy->one().windowZ, GL_DEPTH_COMPONENT);
}

osg::ref_ptr<osg::Image> CopiedView::read(osg::Texture2D& texture, GLenum format)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texture.getTextureWidth(), texture.getTextureHeight(), 1,
                         format == GL_DEPTH_COMPONENT ? GL_LUMINANCE : format, GL_FLOAT);
    camera().getGraphicsContext()->makeCurrent();
    state().applyTextureAttribute(0, &texture);
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, image->data());
    camera().getGraphicsContext()->releaseContext();
    return image;
}

osg::ref_ptr<osg::Node> createCurtain(int bin)
{
    osg::ref_ptr<osg::Node> curtain = scenes::createQuad(osg::Vec3(-5, -9, 1), osg::Vec3(7, 0, 0),
                                                         osg::Vec3(0, 0, 3), osg::Vec4(1, 0, 1, 1));
    curtain->getOrCreateStateSet()->setRenderBinDetails(bin, "RenderBin");
    return curtain;
}

osg::ref_ptr<osg::Program> createColourProgram(const std::string& uniform)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       "#version 130\nuniform vec4 " + uniform +
                                           ";\nvoid main() { gl_FragColor = " + uniform + "; }"));
    return program;
}
