#ifndef OSGWATERREFLECT_DYNAMICS_WATERDYNAMICS_H
#define OSGWATERREFLECT_DYNAMICS_WATERDYNAMICS_H

#include <osgWaterReflect/WaveModel>

#include <osg/FrameStamp>

#include <mutex>

namespace osgWaterReflect
{

/// What advances with time in one water: its waves now, made once for each frame, whatever the
/// views. States never change, so that a draw which is still under way keeps its own, and there are
/// as many as there are frames in flight.
///
/// Any thread may ask. Waves are set where a scene graph may be changed.
class WaterDynamics
{
public:
    /// The next state is that of these waves; null for calm water.
    void setWaves(const WaveModel* waves);

    /// The state for a frame, or for time 0 where there is none: made by the first to ask for a
    /// frame of this number and time. That is the update traversal; the first cull, where none was
    /// made. Null where the water is calm.
    osg::ref_ptr<const WaveState> advance(const osg::FrameStamp* frame);

    /// The state at any time [s]: that of the last frame where it is the same.
    osg::ref_ptr<const WaveState> at(double time) const;

private:
    mutable std::mutex _mutex;
    osg::ref_ptr<const WaveModel> _waves;
    osg::ref_ptr<const WaveState> _state; // null until a frame asks for it
    unsigned int _frameNumber = 0;        // of the state
    double _time = 0.0;                   // [s] of the state
};

} // namespace osgWaterReflect

#endif
