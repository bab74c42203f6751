#include "WaterDynamics.h"

#include <osg/Notify>

using namespace osgWaterReflect;

namespace
{

class StillState : public WaveState
{
public:
    double getHeight(const osg::Vec2d&) const override { return 0.0; }
    osg::Vec3d getNormal(const osg::Vec2d&) const override { return osg::Vec3d(0.0, 0.0, 1.0); }
    void apply(osg::StateSet&, const osg::Vec2d&) const override {}
};

osg::ref_ptr<const WaveState> stateOf(const WaveModel& waves, double time)
{
    const osg::ref_ptr<const WaveState> state = waves.createState(time);
    if (state) return state;
    static std::once_flag said;
    std::call_once(said,
                   [&]
                   {
                       OSG_WARN << "WaveModel::createState: expected a state, got null of "
                                << waves.getCompoundClassName() << "; the water is taken for still"
                                << std::endl;
                   });
    return new StillState;
}

} // namespace

void WaterDynamics::setWaves(const WaveModel* waves)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    _waves = waves;
    _state = nullptr;
}

osg::ref_ptr<const WaveState> WaterDynamics::advance(const osg::FrameStamp* frame)
{
    const unsigned int number = frame ? frame->getFrameNumber() : 0;
    const double time = frame ? frame->getSimulationTime() : 0.0;
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_waves || (_state && _frameNumber == number && _time == time)) return _state;
    _state = stateOf(*_waves, time);
    _frameNumber = number;
    _time = time;
    return _state;
}

osg::ref_ptr<const WaveState> WaterDynamics::at(double time) const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_waves || (_state && _time == time)) return _state;
    return stateOf(*_waves, time);
}
