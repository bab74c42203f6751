#include "Measures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

using namespace osgwaterbench;

namespace
{

// 1.5 pixels on a surface whose steepness is tan(76 degrees) = 4.
const double NEAR_PIXEL_SIDES = 6.0;

Outcome outcomeOf(const ViewPixels& pixels, const ReflectedPlace& truth, const Answer& answer,
                  double thickness)
{
    if (truth.trueClass == TrueClass::SKY)
        return answer.sky ? Outcome::CORRECT : Outcome::FALSE_HIT;
    if (answer.sky) return Outcome::MISSED;
    return showsPlace(pixels, truth, answer.placeWorld, thickness) ? Outcome::CORRECT
                                                                   : Outcome::MISPLACED;
}

} // namespace

Tally Measures::all() const
{
    return std::accumulate(classes.begin(), classes.end(), Tally(),
                           [](Tally sum, const Tally& tally) { return sum += tally; });
}

std::optional<double> Measures::percentOfWater(TrueClass trueClass, Outcome outcome) const
{
    return percentOf(of(trueClass).count(outcome), all().total());
}

bool osgwaterbench::showsPlace(const ViewPixels& pixels, const ReflectedPlace& truth,
                               const glm::dvec3& shownWorld, double thickness)
{
    if (!(pixels.distance(truth.placeWorld, shownWorld) <= MATCH_PIXELS)) return false;
    if (truth.trueClass == TrueClass::VISIBLE) return true;
    const double reach = std::max(thickness, NEAR_PIXEL_SIDES * pixels.pixelSide(truth.placeWorld));
    return glm::distance(truth.placeWorld, shownWorld) <= reach;
}

Measures osgwaterbench::measure(const DrawnWater& drawn, const Truth& truth, const Answers& answers,
                                double thickness)
{
    const ViewPixels pixels(drawn);
    Measures measures;
    std::vector<double> errors;
    double fetches = 0.0;
    for (const TruePixel& own : truth)
    {
        const Answer& answer = answers.at(own.pixel);
        const ReflectedPlace& reflected = own.reflected;
        const Outcome outcome = outcomeOf(pixels, reflected, answer, thickness);
        ++measures.classes[static_cast<int>(reflected.trueClass)].counts[static_cast<int>(outcome)];
        if (reflected.trueClass == TrueClass::VISIBLE && !answer.sky)
            errors.push_back(pixels.distance(reflected.placeWorld, answer.placeWorld));
        fetches += answer.fetches;
    }
    measures.hitErrorPixels = percentilesOf(std::move(errors));
    if (!truth.empty()) measures.meanFetches = fetches / static_cast<double>(truth.size());
    return measures;
}
