#ifndef OSGWATERREFLECT_CAPTURE_MIRROREDCAPTURE_H
#define OSGWATERREFLECT_CAPTURE_MIRROREDCAPTURE_H

#include "../passes/ImagePass.h"
#include "CapturedScene.h"

namespace osgWaterReflect
{

/// What a view's eye sees that is mirrored in a plane of water, drawn before the view: of the scene
/// what lies above that plane, undersides included. Without a guard band.
class MirroredCapture : public Capture
{
public:
    /// The fragment shader of what makes its windowZ.
    static constexpr const char* STRAIGHTEN = "straighten_depth.frag";

    MirroredCapture();

    osg::Texture2D* windowZ() const override { return _straightened->image(); }
    bool isMirrored() const override { return true; }

    /// Culls and draws the scene.
    ///   eye        a mirrored one
    ///   amplitude  [local units] of the highest waves: how far under the still water rays start
    void draw(const CulledView& view, const CaptureEye& eye, const CaptureSize& size,
              double amplitude);

    const CapturedScene& scene() const { return _scene; }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    void straighten(const glm::dvec4& straightened);

    CapturedScene _scene;
    const osg::ref_ptr<ImagePass> _straightened;
};

} // namespace osgWaterReflect

#endif
