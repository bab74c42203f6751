#ifndef OSGWATERREFLECT_TESTS_BATTERY_RECORDEDVIEW_H
#define OSGWATERREFLECT_TESTS_BATTERY_RECORDEDVIEW_H

#include "RayImage.h"
#include "RayProbe.h"

#include <vector>

namespace battery
{

/// What water has reflected in a view of a scene: the image that its rays were looked for in, and a
/// ray for each of its pixels.
struct RecordedView
{
    RayImage image;
    std::vector<Ray> rays;
};

/// Views of a harbour, level, steep, grazing, rolled, wide, orthographic and from under the water,
/// which is calm or moves. Drawn by the library, whose captures and normals they are.
std::vector<RecordedView> recordViews();

} // namespace battery

#endif
