#ifndef OSGWATERREFLECT_VIEW_WATERVIEW_H
#define OSGWATERREFLECT_VIEW_WATERVIEW_H

#include "../capture/CopiedCapture.h"
#include "../capture/DrawnCapture.h"
#include "../capture/MirroredCapture.h"
#include "../images/DepthCells.h"
#include "../images/SkyImage.h"
#include "../water/LowResTrace.h"
#include "../water/WaterDraw.h"
#include "FramePace.h"
#include "ViewPlan.h"

#include <osg/observer_ptr>

#include <functional>
#include <list>
#include <mutex>

namespace osgWaterReflect
{

/// The water of one view. Its cull enrols each sheet that it meets; when that cull is over, the
/// plan is made and carried out. All that outlives a frame is held here: captures, for HOLD_TIME
/// after their last use, and what draws each sheet, as long as the sheet lives.
///
/// Only the thread of the view's cull draws; any thread may release.
class WaterView : public osg::Referenced
{
public:
    /// [s] A capture that is not used is kept for so long: at a threshold the choice may come and
    /// go, and textures are not to come and go with it.
    static constexpr double HOLD_TIME = 3.0;

    ///   sceneCamera  below which the scene is; see CulledView
    ///   stageCamera  whose image the water is drawn in
    ///   clock        [s] monotonic; outlives this
    WaterView(osg::Camera& sceneCamera, osg::Camera& stageCamera,
              const std::function<double()>& clock);

    /// Whether it is that of these cameras.
    bool isOf(const osg::Camera& sceneCamera, const osg::Camera& stageCamera) const;

    /// Whether its cameras still live.
    bool isAlive() const { return _sceneCamera.valid() && _stageCamera.valid(); }

    /// Adds a sheet to the view, which is at the water node in its traversal.
    void enrol(osgUtil::CullVisitor& view, const EnrolledSheet& enrolled);

    /// To be called for each water that is released: releases what is held with the last of the
    /// view's waters, for they share captures and programs.
    void release(const WaterSurface& water, osg::State* state);

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize);

    /// What is held now, for those who look for leaks: captures that have images, and draws.
    std::size_t numCaptures() const;
    std::size_t numDraws() const;

protected:
    ~WaterView() override = default;

private:
    class WhenCulled;

    template <typename Kind>
    struct HeldCapture
    {
        osg::ref_ptr<Kind> capture; // null: none is held
        osg::ref_ptr<DepthCells> cells;
        osg::ref_ptr<SkyImage> sky;
        double lastUsed = 0.0; // [s]
        bool released = true;  // none is held
    };

    struct HeldDraw
    {
        osg::observer_ptr<const WaterSurface> water;
        osg::observer_ptr<const StillWater> sheet;
        osg::ref_ptr<WaterDraw> draw;
        unsigned int cull = 0; // number of the cull that enrolled it last
        bool released = false; // since then
    };

    void begin(osgUtil::CullVisitor& view);
    bool isEnrolling(osgUtil::RenderStage& stage) const;
    osg::ref_ptr<WaterDraw> drawFor(const WaterSurface& water, const StillWater& sheet);

    void finish();
    void plan();
    NdcExtent cullScene(EyeImage image, const GuardBandRequest& request);
    void capture();
    void draw();
    void report();
    void letGo();

    template <typename Kind>
    void use(HeldCapture<Kind>& held);
    template <typename Visit>
    void forEachCapture(const Visit& visit);
    template <typename Kind>
    SearchedCapture searched(const HeldCapture<Kind>& held, const ViewPlan::Sheet& sheet,
                             bool sky) const;
    template <typename Visit>
    void forEachGLObjects(const Visit& visit) const;

    const osg::observer_ptr<osg::Camera> _sceneCamera;
    const osg::observer_ptr<osg::Camera> _stageCamera;
    const std::function<double()>& _clock;
    osg::ref_ptr<FramePace> _pace; // null until a frame time is to be kept

    // Of this frame.
    CulledView _view;
    std::vector<VisibleSheet> _visible;
    ViewPlan _plan;
    WaterStatus _status;
    unsigned int _cull = 0; // its number

    mutable std::mutex _mutex; // of what is held
    HeldCapture<DrawnCapture> _drawn;
    HeldCapture<CopiedCapture> _copied;
    std::vector<HeldCapture<MirroredCapture>> _mirrored;
    osg::ref_ptr<LowResTrace> _trace;
    std::list<HeldDraw> _draws;
    std::string _unsteadyShadows; // found in the scene
    bool _shadowsLookedFor = false;
};

} // namespace osgWaterReflect

#endif
