#ifndef OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H
#define OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H

#include <osgUtil/CullVisitor>

#include <vector>

namespace osgWaterReflect
{

class WaterSurface;

/// Culls the scene once more for a capture: with render stages, state and near and far planes of
/// its own, so that the view's own cull is left as it was. Water that it meets is not drawn but
/// noted.
class CaptureVisitor : public osgUtil::CullVisitor
{
public:
    META_NodeVisitor(osgWaterReflect, CaptureVisitor)

    /// Culls what a view's camera draws into a stage, as the view does.
    ///   view        in the middle of its cull of that camera
    ///   projection  the view's; clamped, like the view's later, to near and far of what is drawn
    void cull(osgUtil::CullVisitor& view, osgUtil::RenderStage& stage, osg::RefMatrix& projection);

    /// Water met by the last cull.
    void meet(const WaterSurface& water) { _waters.push_back(&water); }
    const std::vector<const WaterSurface*>& waters() const { return _waters; }

    using osgUtil::CullVisitor::apply;
    void apply(osg::Camera& camera) override;

private:
    osg::ref_ptr<osgUtil::StateGraph> _captureStateGraph = new osgUtil::StateGraph;
    osg::ref_ptr<osg::StateSet> _stageState = new osg::StateSet;
    std::vector<const WaterSurface*> _waters;
};

} // namespace osgWaterReflect

#endif
