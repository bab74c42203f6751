#ifndef OSGWATERREFLECT_VIEW_STATUSBOARD_H
#define OSGWATERREFLECT_VIEW_STATUSBOARD_H

#include <osgWaterReflect/WaterStatus>

#include <mutex>

namespace osgWaterReflect
{

/// What the views of one water say of their last frame. Any thread may write and read.
class StatusBoard
{
public:
    /// Takes the place of what was said of the same sheet by the same camera.
    void publish(const WaterStatus& status);

    /// All that was said by cameras that still live.
    std::vector<WaterStatus> read() const;

private:
    mutable std::mutex _mutex;
    std::vector<WaterStatus> _all;
};

} // namespace osgWaterReflect

#endif
