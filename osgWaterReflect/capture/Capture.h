#ifndef OSGWATERREFLECT_CAPTURE_CAPTURE_H
#define OSGWATERREFLECT_CAPTURE_CAPTURE_H

#include "../pyramid/ImagePass.h"
#include "CaptureVisitor.h"
#include "FrameCopy.h"
#include "GuardBand.h"
#include "MirroredEye.h"
#include "NdcExtent.h"

#include <osg/Camera>
#include <osg/Texture2D>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <functional>

namespace osgWaterReflect
{

class BandDemand;
struct StageContent;

/// An image of the scene without its water, and the matrix it was taken with: what one camera of
/// one view sees this frame, or what its eye mirrored in water does, rendered before that camera.
///
/// | image   | format                                         | size                         |
/// |---------|------------------------------------------------|------------------------------|
/// | colour  | RGBA8, or that of the camera's own buffer      | viewport times captureScale, |
/// |         |                                                | and the guard band           |
/// | windowZ | 24-bit depth; R32F where it is a mirrored eye's | the same                     |
///
/// The textures are made for the largest band, of which a frame uses a part.
class Capture : public osg::Referenced
{
public:
    /// Of the camera of every capture's render stage, for those who look into a frame.
    static constexpr const char* CAMERA_NAME = "osgWaterReflect capture";
    static constexpr const char* MIRROR_CAMERA_NAME = "osgWaterReflect mirror";

    /// The fragment shader of what makes a mirrored eye's windowZ.
    static constexpr const char* STRAIGHTEN = "straighten_depth.frag";

    Capture();

    /// Renders the capture before the view's current stage, unless that has been arranged in this
    /// cull already. The most demanding of the waters that it meets set scale and guard band (a
    /// mirrored eye's capture has none), and the highest waves how much under a mirrored eye's
    /// floor is drawn. Where all that look for their rays in it ask for CaptureKind::FRAME, only
    /// the band is rendered so, and the rest copied in the middle of the view's stage, before the
    /// water.
    ///   settingsOf  what water is drawn with
    using SettingsOf = std::function<ReflectionSettings(const WaterSurface& water)>;
    void require(osgUtil::CullVisitor& view, const CaptureEye& eye, const SettingsOf& settingsOf);

    /// Whether it has been, in this cull.
    bool isArranged(osgUtil::CullVisitor& view) const;

    /// Whether water can be reflected for this camera: not while it renders depth alone (a shadow
    /// map), nor into an empty viewport.
    static bool serves(osgUtil::CullVisitor& view);

    osg::Texture2D* colour() const { return _colour.get(); }
    osg::Texture2D* windowZ() const { return _mirrored ? _straightened->image() : _windowZ.get(); }
    bool isMirrored() const { return _mirrored; }
    const osg::Vec4& clearColour() const { return _stage->getClearColor(); }

    /// [pixels] Of the lower left part of the textures that is in use, and of all.
    const glm::ivec2& size() const { return _size; }
    const glm::ivec2& capacity() const { return _capacity; }

    /// What of that lies beyond the view.
    const GuardBand& band() const { return _band; }

    /// Whether its ADAPTIVE band, were it as wide as was asked for, would reach far enough for the
    /// rays of all but the steepest places of waves.
    bool bandServes() const { return _bandServes; }

    /// From the view's eye space to the capture's own clip space, near and far as they were fitted.
    /// That of a mirrored eye turns left for right.
    const glm::dmat4& clipFromEye() const { return _clipFromEye; }

    /// How windowZ changes with depth: by perspective / depth, or by orthographic * depth. The one
    /// that is not in use is 0.
    struct DepthScale
    {
        double perspective = 0.0;
        double orthographic = 0.0;
    };
    DepthScale depthScale() const;

    /// Side of a pixel [world units]: at unit depth in perspective, else itself.
    double pixelExtent() const;

    /// What has rendered the capture when it is done.
    osgUtil::RenderStage& stage() const { return _fromFrame ? _copy->stage() : *_stage; }

    /// Counts the culls that it was arranged in.
    unsigned int serial() const { return _serial; }

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

private:
    void cull(osgUtil::CullVisitor& view, const CaptureEye& eye, osg::RefMatrix& projection,
              const SettingsOf& settingsOf);
    glm::ivec2 scaledViewSize(const osg::Viewport& viewport) const;
    void allocate(const osg::Camera& camera, const BandDemand& demand);
    double highestWaves() const;
    bool isCopyAskedFor() const;
    void keepBand(const StageContent& content, const glm::dmat4& clipFromEye);

    /// Cuts off what is under the floor, from what has been culled with a projection.
    void cutOff(const WaterPlane& floor, osg::RefMatrix& projection);

    osg::ref_ptr<osg::Texture2D> _colour;
    osg::ref_ptr<osg::Texture2D> _windowZ;
    osg::ref_ptr<ImagePass> _straightened; // null until a mirrored eye asks for it
    osg::ref_ptr<FrameCopy> _copy;         // null until a copy of the frame is asked for
    osg::ref_ptr<osg::Camera> _camera;     // holds the attachments; it is no node of the scene
    osg::ref_ptr<osgUtil::RenderStage> _stage;
    osg::ref_ptr<CaptureVisitor> _visitor;
    NdcExtent _culled; // what the last cull was widened to
    GuardBand _band;
    bool _bandServes = true;
    glm::ivec2 _viewSize{0}; // [pixels of the capture]
    glm::ivec2 _size{0};     // the same with the band
    glm::ivec2 _capacity{0};
    glm::ivec2 _allocatedFor{0}; // view size
    glm::dmat4 _projection{1.0}; // its own, near and far as they were fitted
    glm::dmat4 _clipFromEye{1.0};
    bool _mirrored = false;
    bool _fromFrame = false; // but for the band
    unsigned int _serial = 0;
};

} // namespace osgWaterReflect

#endif
