#ifndef OSGWATERREFLECT_VIEW_FRAMEPACE_H
#define OSGWATERREFLECT_VIEW_FRAMEPACE_H

#include "FrameTimeControl.h"

#include <osg/Referenced>
#include <osg/ref_ptr>

#include <functional>
#include <mutex>
#include <optional>

namespace osg
{
class Camera;
}

namespace osgWaterReflect
{

/// How much accuracy the frames of a camera have time for. There is one for each camera, not for
/// each of its CullVisitors: of these a view may have several, which cull every other frame or one
/// eye each. It is kept beside the scene, not in it, so that nothing of it is written with the
/// camera.
class FramePace : public osg::Referenced
{
public:
    FramePace();

    /// The camera's, made on first use; it lives as long as the camera, and any who holds it.
    static osg::ref_ptr<FramePace> of(osg::Camera& camera);

    /// The step for a frame, the same however often it is asked for.
    ///   target    [s] > 0
    ///   numSteps  of accuracy; with another number all is begun anew
    int step(unsigned int frame, double target, int numSteps);

    /// [s] monotonic, for tests to replace.
    std::function<double()> clock;

protected:
    ~FramePace() override = default;

private:
    std::mutex _mutex;
    std::optional<FrameTimeControl> _control;
    int _numSteps = 0;
    unsigned int _frame = 0;
};

} // namespace osgWaterReflect

#endif
