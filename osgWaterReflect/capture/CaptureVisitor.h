#ifndef OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H
#define OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H

#include "CulledView.h"
#include "SeenPyramid.h"

#include <osgUtil/CullVisitor>

#include <string>

namespace osgWaterReflect
{

/// Culls the scene of a view once more for a capture: with render stages, state and near and far
/// planes of its own, so that the view's own cull is left as it was. Water is left out.
class CaptureVisitor : public osgUtil::CullVisitor
{
public:
    META_NodeVisitor(osgWaterReflect, CaptureVisitor)

    /// Culls what is below the view's camera into a stage, as the view does: with its lights, and
    /// at the level of detail that it sees, wherever the capture's own eye is. The stage's camera
    /// is a CaptureCamera; it is yet to be sorted.
    ///   eyeFromViewEye  rigid, for row vectors
    ///   projection      clamped, like the view's, to near and far of what is drawn
    ///   viewport        that goes with it, in the view's pixels: decides levels of detail
    ///   shown           what lies in it as a whole is left out, and does not count for near and
    ///                   far; null: nothing
    void cull(const CulledView& view, osgUtil::RenderStage& stage,
              const osg::Matrixd& eyeFromViewEye, osg::RefMatrix& projection,
              osg::Viewport& viewport, const SeenPyramid* shown = nullptr);

    /// Whether the projection was clamped in the last cull: not where it met nothing.
    bool isFitted() const;

    /// The shadow technique met by any cull so far that fits its shadows to each cull, by its
    /// class; empty: none.
    const std::string& unsteadyShadows() const { return _unsteadyShadows; }

    using osgUtil::CullVisitor::apply;
    void apply(osg::Group& group) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Camera& camera) override;
    void apply(osg::Drawable& drawable) override;

private:
    void inheritLights(const CulledView& view, osgUtil::RenderStage& stage,
                       const osg::Matrixd& eyeFromViewEye);
    void tellShaders(const osg::Matrixd& eyeFromWorld, bool anotherEye);
    bool isShown(const osg::Node& node);

    osg::ref_ptr<osgUtil::StateGraph> _captureStateGraph = new osgUtil::StateGraph;
    osg::ref_ptr<osg::StateSet> _stageState = new osg::StateSet;
    std::string _unsteadyShadows;

    const SeenPyramid* _shown = nullptr; // of the cull under way
};

} // namespace osgWaterReflect

#endif
