#include "SearchError.h"

#include "Tally.h"
#include "ViewPixels.h"

#include <utility>

using namespace osgwaterbench;
using osgWaterReflect::reference::ImageReason;

std::optional<double> SearchError::disagreedPercent() const
{
    return percentOf(waterPixels - agreed, waterPixels);
}

SearchError osgwaterbench::compareSearch(const DrawnWater& drawn, const ImageTruth& truth,
                                         const Answers& answers)
{
    const ViewPixels pixels(drawn);
    SearchError error;
    std::vector<double> distances;
    for (const ImagePixel& own : truth)
    {
        const Answer& answer = answers.at(own.pixel);
        bool agreed = own.found() != answer.sky;
        if (own.found() && !answer.sky)
        {
            distances.push_back(pixels.distance(own.placeWorld, answer.placeWorld));
            agreed = distances.back() <= MATCH_PIXELS;
        }
        ++error.waterPixels;
        error.agreed += agreed;
        error.answeredBehind += own.reason == ImageReason::BEHIND && !answer.sky;
    }
    error.errorPixels = percentilesOf(std::move(distances));
    return error;
}
