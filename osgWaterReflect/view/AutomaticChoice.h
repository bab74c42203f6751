#ifndef OSGWATERREFLECT_VIEW_AUTOMATICCHOICE_H
#define OSGWATERREFLECT_VIEW_AUTOMATICCHOICE_H

#include "../water/WaterSettings.h"

namespace osgWaterReflect
{

/// What a view shows of the waters that leave the kind of their capture to it.
struct SceneFacts
{
    bool calm = true;         ///< all of them
    int planes = 1;           ///< that they lie in
    bool bandServes = true;   ///< under its ceiling the guard band reaches as far as they reflect,
                              ///< but for the steepest places of waves
    bool redrawsAlike = true; ///< the scene drawn once more has the same shadows
};

/// Settings without AUTOMATIC; whatever else was asked for stays.
///
/// | capture | where |
/// |---|---|
/// | FRAME, without a guard band | the scene drawn once more would have other shadows |
/// | MIRROR | all are calm and in one plane: it is exact, undersides included |
/// | VIEW_AND_MIRROR | in one plane, but the ceiling cuts the band short: steep views, high waves |
/// | VIEW | elsewhere: one drawing of the scene for all planes |
///
/// The search is HIERARCHICAL, in captures of any size.
WaterSettings settle(const WaterSettings& asked, const SceneFacts& facts);

} // namespace osgWaterReflect

#endif
