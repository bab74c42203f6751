#ifndef OSGWATERBENCH_SEARCHERROR_H
#define OSGWATERBENCH_SEARCHERROR_H

#include "ImageTruth.h"
#include "Percentiles.h"

namespace osgwaterbench
{

/// A search's own error: what it does otherwise than the exhaustive one in the same image. What the
/// image itself has lost is no part of it.
struct SearchError
{
    std::size_t waterPixels = 0;
    std::size_t agreed = 0; ///< both found nothing, or places within MATCH_PIXELS

    /// Of those that do not agree: the exhaustive search ended behind something, the answer is a
    /// place. The water may show what hides the ray's end there by its own rule.
    std::size_t answeredBehind = 0;

    std::optional<Percentiles> errorPixels; ///< [pixels] of the view, where both found a place

    std::optional<double> disagreedPercent() const; ///< of the water pixels; none of none
};

SearchError compareSearch(const DrawnWater& drawn, const ImageTruth& truth, const Answers& answers);

} // namespace osgwaterbench

#endif
