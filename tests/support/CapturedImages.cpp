#include "CapturedImages.h"

#include "Catch.h"

#include <osgWaterReflect/capture/MirroredCapture.h>

#include <osgUtil/RenderStage>
#include <osgViewer/Renderer>

#include <cstring>

using osgWaterReflect::Capture;
using osgWaterReflect::MirroredCapture;

namespace
{

// A texture's lower left part that a viewport covers; all of it without one.
osg::ref_ptr<osg::Image> read(osg::State& state, osg::Texture2D& texture, GLenum format,
                              GLenum type, const osg::Viewport* part = nullptr)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    const GLenum imageFormat = format == GL_DEPTH_COMPONENT ? GL_LUMINANCE : format;
    image->allocateImage(texture.getTextureWidth(), texture.getTextureHeight(), 1, imageFormat,
                         type);
    // Not by applyTextureAttribute, which leaves the active unit alone where the texture is applied
    // already.
    state.setActiveTextureUnit(0);
    texture.apply(state);
    state.haveAppliedTextureAttribute(0, &texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, format, type, image->data());
    return part ? lowerLeftPart(*image, part->width(), part->height()) : image;
}

osg::Texture2D* attached(const osg::Camera& camera, osg::Camera::BufferComponent buffer)
{
    const auto found = camera.getBufferAttachmentMap().find(buffer);
    REQUIRE(found != camera.getBufferAttachmentMap().end());
    return dynamic_cast<osg::Texture2D*>(found->second._texture.get());
}

void collect(const CapturedImages& to, osg::State& state, const osgUtil::RenderStage& stage)
{
    for (const auto& entry : stage.getPreRenderList())
    {
        const osgUtil::RenderStage& before = *entry.second;
        const osg::Camera* camera = before.getCamera();
        to.stages += 1 + before.getPostRenderList().size();
        collect(to, state, before);
        if (!camera) continue;
        const bool mirrored = camera->getName() == Capture::MIRROR_CAMERA_NAME;
        if (!mirrored && camera->getName() != Capture::CAMERA_NAME) continue;

        osg::Texture2D* colour = attached(*camera, osg::Camera::COLOR_BUFFER0);
        osg::Texture2D* windowZ = attached(*camera, osg::Camera::DEPTH_BUFFER);
        const bool bytes = colour->getInternalFormat() == GL_RGBA8;
        CapturedImage image;
        image.of = stage.getCamera();
        image.mirrored = mirrored;
        image.clipFromEye = camera->getProjectionMatrix();
        image.colourFormat = colour->getInternalFormat();
        image.colour = read(state, *colour, GL_RGBA, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT,
                            camera->getViewport());
        image.windowZ = read(state, *windowZ, GL_DEPTH_COMPONENT, GL_FLOAT, camera->getViewport());
        to.images.push_back(image);
        to.textures.push_back(colour);
        to.textures.push_back(windowZ);
        for (const auto& after : before.getPostRenderList())
            if (after.second->getCamera()->getName() ==
                std::string("osgWaterReflect ") + MirroredCapture::STRAIGHTEN)
                to.textures.push_back(
                    attached(*after.second->getCamera(), osg::Camera::COLOR_BUFFER0));
    }
}

} // namespace

osg::ref_ptr<osg::Texture2D> createWindowZTexture(int width, int height)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(width, height);
    texture->setInternalFormat(GL_DEPTH_COMPONENT24);
    texture->setSourceFormat(GL_DEPTH_COMPONENT);
    texture->setSourceType(GL_UNSIGNED_INT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

osg::ref_ptr<osg::Image> lowerLeftPart(const osg::Image& image, int width, int height)
{
    REQUIRE(width <= image.s());
    REQUIRE(height <= image.t());
    osg::ref_ptr<osg::Image> part = new osg::Image;
    part->allocateImage(width, height, 1, image.getPixelFormat(), image.getDataType());
    for (int row = 0; row < height; ++row)
        std::memcpy(part->data(0, row), image.data(0, row), part->getRowSizeInBytes());
    return part;
}

osg::ref_ptr<CapturedImages> CapturedImages::of(osg::Camera& camera)
{
    osg::ref_ptr<CapturedImages> captured = new CapturedImages;
    camera.setPostDrawCallback(captured);
    return captured;
}

void CapturedImages::operator()(osg::RenderInfo& renderInfo) const
{
    osg::Camera& camera = *renderInfo.getCurrentCamera();
    auto* renderer = dynamic_cast<osgViewer::Renderer*>(camera.getRenderer());
    REQUIRE(renderer);
    images.clear();
    textures.clear();
    stages = 0;
    collect(*this, *renderInfo.getState(), *renderer->getSceneView(0)->getRenderStage());

    if (camera.getBufferAttachmentMap().count(osg::Camera::DEPTH_BUFFER))
        frameWindowZ = read(*renderInfo.getState(), *attached(camera, osg::Camera::DEPTH_BUFFER),
                            GL_DEPTH_COMPONENT, GL_FLOAT);
}

const CapturedImage& CapturedImages::one() const
{
    REQUIRE(images.size() == 1);
    return images.front();
}
