#include "AnySettings.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;

double anyNumber(Chance& chance)
{
    using Limits = std::numeric_limits<double>;
    const double limit =
        chance.oneOf({0.0, -0.0, 1.0, 64.0, 3.0, -1.0, Limits::quiet_NaN(), Limits::infinity(),
                      -Limits::infinity(), Limits::denorm_min(), Limits::max()});
    switch (chance.integer(0, 3))
    {
    case 0:
        return limit;
    case 1:
        return std::nextafter(limit, chance.oneOf({1e9, -1e9}));
    case 2:
        return std::pow(10.0, chance.between(-30.0, 30.0));
    default:
        return chance.between(0.0, 1.0);
    }
}

double numberWithin(const Range& range, Chance& chance)
{
    const bool bounded = range.highest < Range::LARGEST;
    if (chance.once(8) && range.lowestIncluded) return range.lowest;
    if (chance.once(8) && bounded) return range.highest;
    if (!bounded) return range.lowest + chance.logBetween(1e-6, 1e6);
    if (range.lowestIncluded) return chance.between(range.lowest, range.highest);
    return range.lowest + (range.highest - range.lowest) * chance.logBetween(1e-3, 1.0);
}

double numberAbout(const Range& range, Chance& chance)
{
    const double bound = chance.oneOf({range.lowest, range.highest});
    switch (chance.integer(0, 3))
    {
    case 0:
        return chance.oneOf(
            {bound, std::nextafter(bound, Range::LARGEST), std::nextafter(bound, -Range::LARGEST)});
    case 1:
        return anyNumber(chance);
    default:
        return numberWithin(range, chance);
    }
}

std::vector<TrochoidalWave> anyWaves(Chance& chance)
{
    std::vector<TrochoidalWave> waves(chance.integer(0, 4));
    for (TrochoidalWave& wave : waves)
    {
        if (chance.once(2)) wave.amplitude = anyNumber(chance);
        if (chance.once(2)) wave.length = anyNumber(chance);
        if (chance.once(4)) wave.directionDegrees = anyNumber(chance);
        if (chance.once(4)) wave.phase = anyNumber(chance);
    }
    return waves;
}
