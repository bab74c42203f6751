#ifndef OSGWATERREFLECT_CAPTURE_CAPTUREDSCENE_H
#define OSGWATERREFLECT_CAPTURE_CAPTUREDSCENE_H

#include "Capture.h"
#include "CaptureVisitor.h"
#include "MirroredEye.h"
#include "StageContent.h"

namespace osgWaterReflect
{

/// The scene of a view, culled once more into a capture's render stage.
class CapturedScene
{
public:
    explicit CapturedScene(osgUtil::RenderStage& stage) : _stage(stage) {}

    /// Which of it is culled.
    enum class Part
    {
        ALL,
        BEYOND_VIEW ///< but for what the view itself shows as a whole
    };

    /// Culls it from an eye, as far as an extent of what that eye sees reaches.
    void cull(const CulledView& view, const CaptureEye& eye, const NdcExtent& extent,
              Part part = Part::ALL);

    /// How far reaches what was culled and lies beyond the view; see StageContent.
    NdcExtent seenBeyondView(bool skies, const NdcExtent& asked) const
    {
        return _content.seenBeyondView(skies, asked);
    }

    /// Sets the projection that it is drawn with to the eye's with a band, near and far as they
    /// were fitted, and leaves out what that does not show. Returns it.
    glm::dmat4 fitTo(const CaptureSize& size);

    /// Readies what is left for drawing.
    void finish() { _stage.sort(); }

    /// What all that was culled is drawn with.
    osg::RefMatrix& projection() const { return *_projection; }
    const CaptureEye& eye() const { return _eye; }

    /// The shadow technique met so far that fits its shadows to each cull, by its class; empty:
    /// none.
    const std::string& unsteadyShadows() const { return _visitor->unsteadyShadows(); }

private:
    void includeView(const CulledView& view);

    osgUtil::RenderStage& _stage; // of the capture that holds this
    const osg::ref_ptr<CaptureVisitor> _visitor = new CaptureVisitor;
    osg::ref_ptr<osg::RefMatrix> _projection;
    CaptureEye _eye;
    StageContent _content;    // where more than the view was culled
    bool _reachesOut = false; // more was
};

} // namespace osgWaterReflect

#endif
