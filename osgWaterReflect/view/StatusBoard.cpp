#include "StatusBoard.h"

#include <algorithm>

using namespace osgWaterReflect;

// Assigned over what was there: its vectors' memory is used again.
void StatusBoard::publish(const WaterStatus& status)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    const auto same =
        std::find_if(_all.begin(), _all.end(),
                     [&](const WaterStatus& other)
                     { return other.camera == status.camera && other.sheet == status.sheet; });
    if (same != _all.end())
    {
        *same = status;
        return;
    }
    _all.erase(std::remove_if(_all.begin(), _all.end(),
                              [](const WaterStatus& other) { return !other.camera.valid(); }),
               _all.end());
    _all.push_back(status);
}

std::vector<WaterStatus> StatusBoard::read() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    std::vector<WaterStatus> all = _all;
    all.erase(std::remove_if(all.begin(), all.end(),
                             [](const WaterStatus& status) { return !status.camera.valid(); }),
              all.end());
    return all;
}
