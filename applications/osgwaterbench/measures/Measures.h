#ifndef OSGWATERBENCH_MEASURES_H
#define OSGWATERBENCH_MEASURES_H

#include "Percentiles.h"
#include "Tally.h"
#include "Truth.h"

#include <array>

namespace osgwaterbench
{

/// How good one method's answers are.
struct Measures
{
    std::array<Tally, TRUE_CLASS_COUNT> classes;

    /// [pixels] between the true and the shown place, of VISIBLE pixels that show a place:
    /// MISPLACED ones too, with all they err by.
    std::optional<Percentiles> hitErrorPixels;

    std::optional<double> meanFetches; ///< a water pixel; none where there is none

    const Tally& of(TrueClass trueClass) const { return classes[static_cast<int>(trueClass)]; }
    Tally all() const; ///< over all classes: every water pixel once

    /// Of all water pixels; none where there are none.
    std::optional<double> percentOfWater(TrueClass trueClass, Outcome outcome) const;
};

/// Whether an answer shows a true place: seen within MATCH_PIXELS of it.
///
/// In the image's own direction what hides a place is seen there as well, and so, through the
/// image's edge, is whatever else lies that way. Unless VISIBLE, a place must therefore also be
/// near in space: no farther than the thickness, which the search takes a surface to have anyway,
/// or than 6 pixels' sides at the true place, what MATCH_PIXELS come to on a surface 76 degrees
/// steep against the image plane (ImageTracer's bound of one surface).
///   thickness  [world units] > 0
bool showsPlace(const ViewPixels& pixels, const ReflectedPlace& truth, const glm::dvec3& shownWorld,
                double thickness);

/// Measures answers at the truth's pixels.
///   thickness  [world units] > 0, as showsPlace() takes it
Measures measure(const DrawnWater& drawn, const Truth& truth, const Answers& answers,
                 double thickness);

} // namespace osgwaterbench

#endif
