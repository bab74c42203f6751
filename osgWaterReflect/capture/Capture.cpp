#include "Capture.h"

#include "../Transforms.h"
#include "../trace/Bindings.h"
#include "BandDemand.h"
#include "StageContent.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/ContextData>
#include <osg/FrameBufferObject>

#include <glm/common.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<osg::Texture2D> createImage(GLint internalFormat, GLenum format, GLenum type,
                                         osg::Texture::FilterMode filter)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setInternalFormat(internalFormat);
    texture->setSourceFormat(format);
    texture->setSourceType(type);
    texture->setFilter(osg::Texture::MIN_FILTER, filter);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

// The format that a camera renders its colour to; RGBA8 where that is the window's.
GLint colourFormat(const osg::Camera& camera)
{
    if (camera.getRenderTargetImplementation() == osg::Camera::FRAME_BUFFER) return GL_RGBA8;
    const auto& attachments = camera.getBufferAttachmentMap();
    for (auto buffer : {osg::Camera::COLOR_BUFFER, osg::Camera::COLOR_BUFFER0})
    {
        const auto found = attachments.find(buffer);
        if (found == attachments.end()) continue;
        const osg::Camera::Attachment& attachment = found->second;
        if (attachment._texture.valid() && attachment._texture->getInternalFormat())
            return attachment._texture->getInternalFormat();
        if (attachment._image.valid() && attachment._image->getInternalTextureFormat())
            return attachment._image->getInternalTextureFormat();
        if (attachment._internalFormat) return attachment._internalFormat;
    }
    return GL_RGBA8;
}

// With the band that was asked for in place of the one that they are drawn with.
std::vector<MetWater> asAsked(std::vector<MetWater> waters)
{
    for (MetWater& met : waters)
    {
        const ReflectionSettings& asked = met.water->getReflection();
        met.settings.guardBand = asked.guardBand;
        met.settings.maxExtraPixels = asked.maxExtraPixels;
    }
    return waters;
}

// OSG makes its lists of frame buffers to be deleted when the first goes, without a lock. Captures
// go in cull threads, several at once: the lists are made in the thread that draws, before any
// goes.
class PrepareDeletion : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override
    {
        osg::get<osg::GLFrameBufferObjectManager>(renderInfo.getContextID());
        osg::get<osg::GLRenderBufferManager>(renderInfo.getContextID());
    }
};

// [1] Of half the view's size: how much farther than needed is culled, so that a camera that turns
// slowly does not have everything culled twice.
const double CULL_MARGIN = 0.1;

NdcExtent withMargin(const NdcExtent& extent)
{
    const NdcExtent view;
    return contains(view, extent)
               ? view
               : NdcExtent{extent.left - CULL_MARGIN, extent.right + CULL_MARGIN,
                           extent.bottom - CULL_MARGIN, extent.top + CULL_MARGIN};
}

} // namespace

Capture::Capture() :
    _colour(createImage(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, osg::Texture::LINEAR)),
    _windowZ(createImage(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                         osg::Texture::NEAREST)),
    _camera(new osg::Camera), _stage(new osgUtil::RenderStage), _visitor(new CaptureVisitor)
{
    _windowZ->setShadowComparison(false);
    _camera->setName(CAMERA_NAME);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _colour);
    _camera->attach(osg::Camera::DEPTH_BUFFER, _windowZ);
    _camera->setInitialDrawCallback(new PrepareDeletion);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    _camera->setViewport(_stage->getViewport());
}

bool Capture::serves(osgUtil::CullVisitor& view)
{
    const osg::Camera* camera = view.getCurrentCamera();
    const osg::Viewport* viewport = view.getCurrentRenderStage()->getViewport();
    if (!camera || !viewport || viewport->width() < 1.0 || viewport->height() < 1.0) return false;

    const auto& attachments = camera->getBufferAttachmentMap();
    const bool hasColour = std::any_of(attachments.begin(), attachments.end(),
                                       [](const auto& attachment)
                                       { return attachment.first >= osg::Camera::COLOR_BUFFER; });
    return attachments.empty() || hasColour;
}

bool Capture::isArranged(osgUtil::CullVisitor& view) const
{
    const auto& arranged = view.getCurrentRenderStage()->getPreRenderList();
    return std::any_of(arranged.begin(), arranged.end(),
                       [this](const auto& stage) { return stage.second == _stage; });
}

void Capture::require(osgUtil::CullVisitor& view, const CaptureEye& eye,
                      const SettingsOf& settingsOf)
{
    if (isArranged(view)) return;
    ++_serial;

    const osg::ref_ptr<osg::RefMatrix> projection = new osg::RefMatrix;
    _mirrored = eye.floor.has_value();
    cull(view, eye, *projection, settingsOf);
    _projection = fromOsg(*projection);
    _clipFromEye = _projection * eye.eyeFromViewEye;

    // After every texture of the scene's own that the view renders first.
    view.getCurrentRenderStage()->addPreRenderStage(_stage.get(), INT_MAX);
    if (_mirrored) cutOff(*eye.floor, *projection);
    if (_fromFrame)
    {
        if (!_copy) _copy = new FrameCopy;
        const osg::ref_ptr<osg::Viewport> place =
            new osg::Viewport(_band.left, _band.bottom, _viewSize.x, _viewSize.y);
        _copy->require(view, *_camera, *place, *projection);
    }

    // For draw callbacks that ask it, and for those who look into a frame.
    _camera->setName(_mirrored ? MIRROR_CAMERA_NAME : CAMERA_NAME);
    _camera->setViewMatrix(*_stage->getInitialViewMatrix());
    _camera->setProjectionMatrix(*projection);
}

// The scene is culled, and near and far are fitted, with the projection as it would be without the
// floor: OpenSceneGraph's clamp would move an oblique near plane, and so would its culling a far
// plane. What has been culled refers to the matrix, and is drawn with what it is in the end.
void Capture::cutOff(const WaterPlane& floor, osg::RefMatrix& projection)
{
    const ObliqueProjection oblique = obliqueProjection(_projection, floor, highestWaves());
    projection.set(toOsg(oblique.clipFromEye));

    if (!_straightened) _straightened = new ImagePass(STRAIGHTEN, GL_R32F, GL_RED);
    _straightened->setInput(0, bindings::OBLIQUE_WINDOW_Z, _windowZ);
    const glm::dvec4& straightened = oblique.straightened;
    bindings::set(_straightened->stateSet(), bindings::STRAIGHTENED,
                  osg::Vec4(straightened.x / _size.x, straightened.y / _size.y, straightened.z,
                            straightened.w));
    _straightened->require(*_stage, _size, _capacity);
}

// A capture that is drawn serves the waters that ask for a copy, too.
bool Capture::isCopyAskedFor() const
{
    bool asked = false;
    for (const MetWater& met : _visitor->waters())
    {
        const CaptureKind kind = met.settings.capture;
        if (kind == CaptureKind::VIEW || kind == CaptureKind::VIEW_AND_MIRROR) return false;
        asked = asked || kind == CaptureKind::FRAME;
    }
    return asked;
}

// The frame is to be copied: what it shows as a whole is not drawn again.
void Capture::keepBand(const StageContent& content, const glm::dmat4& clipFromEye)
{
    if (_size != _viewSize)
    {
        content.keepBeyond(clipFromEye);
        return;
    }
    _stage->reset(); // of stages before it, too: shadow maps
    _stage->setClearMask(0);
}

double Capture::highestWaves() const
{
    double amplitude = 0.0;
    for (const MetWater& met : _visitor->waters())
        if (const WaveModel* const waves = met.water->getWaves())
            amplitude = std::max(amplitude, waves->getAmplitude());
    return amplitude;
}

// How wide a capture must be is known only when its waters have been met. So it is culled somewhat
// wider than the last frame's waters asked for, and once more where this frame's ask for more; what
// is then drawn depends on this frame alone.
void Capture::cull(osgUtil::CullVisitor& view, const CaptureEye& eye, osg::RefMatrix& projection,
                   const SettingsOf& settingsOf)
{
    const osg::Viewport& viewport = *view.getViewport();
    const glm::ivec2 viewportSize(std::ceil(viewport.width()), std::ceil(viewport.height()));
    const glm::dmat4& clipFromEye = eye.clipFromEye;
    const double time = view.getFrameStamp() ? view.getFrameStamp()->getSimulationTime() : 0.0;

    const auto cullWithin = [&](const NdcExtent& extent)
    {
        const GuardBand band = bandFor(extent, viewportSize, std::numeric_limits<int>::max());
        const glm::ivec2 size = widened(viewportSize, band);
        const osg::ref_ptr<osg::Viewport> wide = new osg::Viewport(0, 0, size.x, size.y);
        projection.set(toOsg(widened(clipFromEye, viewportSize, band)));
        _visitor->cull(view, *_stage, toOsg(eye.eyeFromViewEye), projection, *wide);
        for (MetWater& met : _visitor->waters())
            met.settings = settingsOf(*met.water);
        return _mirrored ? BandDemand({}, clipFromEye, time)
                         : BandDemand(asAsked(_visitor->waters()), clipFromEye, time);
    };
    // The band as asked for, whatever is given up for time: whether it serves must not depend on
    // it.
    BandDemand demand = cullWithin(_culled);
    if (!contains(_culled, demand.possible()))
    {
        _culled = withMargin(demand.possible());
        demand = cullWithin(_culled);
    }

    _viewSize = scaledViewSize(viewport);
    const StageContent content = {*_stage, projection};
    NdcExtent scene;
    if (demand.adapts()) scene = content.seenThrough(clipFromEye, demand.seesDrawnSky());
    _bandServes = demand.serves(scene, viewportSize);
    const BandDemand given = _mirrored ? demand : BandDemand(_visitor->waters(), clipFromEye, time);
    _band = given.band(scene, _viewSize);
    _size = widened(_viewSize, _band);
    glm::dmat4 wide = widened(clipFromEye, _viewSize, _band);
    for (int column = 0; column < 4; ++column)
        wide[column][2] = projection(column, 2); // near and far as they were fitted
    if (!contains(NdcExtent(), _culled)) content.keepSeenThrough(wide);
    _fromFrame = !_mirrored && isCopyAskedFor();
    if (_fromFrame) keepBand(content, clipFromEye);
    projection.set(toOsg(wide));
    _visitor->finish(*_stage);
    _culled = withMargin(demand.possible());
    allocate(*view.getCurrentCamera(), given);
}

// Of the view, in the capture's pixels.
glm::ivec2 Capture::scaledViewSize(const osg::Viewport& viewport) const
{
    double scale = 0.0;
    for (const MetWater& met : _visitor->waters())
        scale = std::max(scale, met.settings.captureScale);
    if (scale == 0.0) scale = 1.0;
    return {std::max(1L, std::lround(scale * viewport.width())),
            std::max(1L, std::lround(scale * viewport.height()))};
}

// Once some band was needed, textures are as large as any that may be.
void Capture::allocate(const osg::Camera& camera, const BandDemand& demand)
{
    if (_viewSize != _allocatedFor) _capacity = _viewSize;
    _allocatedFor = _viewSize;
    if (_size != _viewSize) _capacity = glm::max(_capacity, demand.largestSize(_viewSize));

    const GLint format = colourFormat(camera);
    if (format != _colour->getInternalFormat())
    {
        _colour->setInternalFormat(format);
        _colour->dirtyTextureObject();
        _camera->dirtyAttachmentMap();
    }
    _camera->resizeAttachments(_capacity.x, _capacity.y);
    _stage->getViewport()->setViewport(0, 0, _size.x, _size.y);
}

Capture::DepthScale Capture::depthScale() const
{
    const bool orthographic = eyePointOf(_projection).w == 0.0;
    if (orthographic) return {0.0, 0.5 * std::abs(_projection[2][2])};
    return {0.5 * std::abs(_projection[3][2]), 0.0};
}

double Capture::pixelExtent() const
{
    const double clipXPerUnit = std::hypot(_projection[0][0], _projection[1][0]);
    return 2.0 / (clipXPerUnit * _size.x);
}

void Capture::releaseGLObjects(osg::State* state) const
{
    _colour->releaseGLObjects(state);
    _windowZ->releaseGLObjects(state);
    if (_straightened) _straightened->releaseGLObjects(state);
    if (_copy) _copy->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void Capture::resizeGLObjectBuffers(unsigned int maxSize)
{
    _colour->resizeGLObjectBuffers(maxSize);
    _windowZ->resizeGLObjectBuffers(maxSize);
    if (_straightened) _straightened->resizeGLObjectBuffers(maxSize);
    if (_copy) _copy->resizeGLObjectBuffers(maxSize);
}
