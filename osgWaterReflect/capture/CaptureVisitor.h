#ifndef OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H
#define OSGWATERREFLECT_CAPTURE_CAPTUREVISITOR_H

#include <osgWaterReflect/ReflectionSettings>

#include <osgUtil/CullVisitor>

#include <glm/mat4x4.hpp>

#include <vector>

namespace osgWaterReflect
{

class StillWater;
class WaterSurface;

/// Water that a capture's cull has met and left out.
struct MetWater
{
    const WaterSurface* water;
    const std::vector<osg::ref_ptr<StillWater>>* sheets;
    glm::dmat4 eyeFromLocal;
    ReflectionSettings settings; ///< that it is drawn with; as asked for until they are settled
};

/// Culls the scene once more for a capture: with render stages, state and near and far planes of
/// its own, so that the view's own cull is left as it was. Water that it meets is not drawn but
/// noted.
class CaptureVisitor : public osgUtil::CullVisitor
{
public:
    META_NodeVisitor(osgWaterReflect, CaptureVisitor)

    /// Culls what a view's camera draws into a stage, as the view does: with its lights, and at the
    /// level of detail that it sees, wherever the capture's own eye is. The stage is yet to be
    /// finished.
    ///   view            in the middle of its cull of that camera
    ///   eyeFromViewEye  rigid, for row vectors
    ///   projection      clamped, like the view's later, to near and far of what is drawn
    ///   viewport        that goes with it, in the view's pixels: decides levels of detail
    void cull(osgUtil::CullVisitor& view, osgUtil::RenderStage& stage,
              const osg::Matrixd& eyeFromViewEye, osg::RefMatrix& projection,
              osg::Viewport& viewport);

    /// Readies what was culled for drawing.
    void finish(osgUtil::RenderStage& stage);

    /// Water met by the last cull.
    virtual void meet(const WaterSurface& water,
                      const std::vector<osg::ref_ptr<StillWater>>& sheets);
    std::vector<MetWater>& waters() { return _waters; }
    const std::vector<MetWater>& waters() const { return _waters; }

    using osgUtil::CullVisitor::apply;
    void apply(osg::Camera& camera) override;

private:
    void tellShaders(const osg::Matrixd& eyeFromWorld, bool anotherEye);

    osg::ref_ptr<osgUtil::StateGraph> _captureStateGraph = new osgUtil::StateGraph;
    osg::ref_ptr<osg::StateSet> _stageState = new osg::StateSet;
    std::vector<MetWater> _waters;
};

} // namespace osgWaterReflect

#endif
