#ifndef OSGWATERREFLECT_VIEW_ACCURACYSTEPS_H
#define OSGWATERREFLECT_VIEW_ACCURACYSTEPS_H

#include "../water/WaterSettings.h"

#include <vector>

namespace osgWaterReflect
{

/// The settings that a view goes through to save time: as asked for first, the fastest last. No
/// step is in any respect more accurate than the one before, but that the copy of step 6 may have a
/// band; and none is the same.
///   asked  with a definite kind of capture: AUTOMATIC stays what it is
///
/// 1. the mirrored image beside the view's: undersides and what is hidden, for a draw of the scene
/// 2. the view's image drawn anew: what is blended, for another draw of the scene but for its band
/// 3. traceScale above 1/2: sharpness, of what waves blur already, for 3/4 of the trace
/// 4. an adaptive band above 1/4 of the view's pixels: what is reflected from far outside the view
/// 5. captureScale above 1/2: thin things (1.1 of 100 pixels are no longer right), for 3/4 of the
///    captured pixels
/// 6. a mirrored image by itself: undersides and what is hidden, for a draw of the scene
/// 7. traceScale above 1/4, and any band: all of the above
std::vector<WaterSettings> accuracySteps(const WaterSettings& asked);

} // namespace osgWaterReflect

#endif
