#ifndef OSGWATERREFLECT_CHOICE_FRAMEPACE_H
#define OSGWATERREFLECT_CHOICE_FRAMEPACE_H

#include "FrameTimeControl.h"

#include <osg/Object>

#include <functional>
#include <mutex>
#include <optional>

namespace osg
{
class Camera;
}

namespace osgWaterReflect
{

/// How much accuracy the frames of a camera have time for. It is attached to the camera, not to
/// its CullVisitors: of these a view may have several, which cull every other frame or one eye
/// each.
class FramePace : public osg::Object
{
public:
    FramePace();
    FramePace(const FramePace& rhs, const osg::CopyOp& copyop) : osg::Object(rhs, copyop)
    {
        clock = rhs.clock;
    }
    META_Object(osgWaterReflect, FramePace)

    /// The camera's, made on first use.
    static FramePace& of(osg::Camera& camera);

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
