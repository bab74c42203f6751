#include "AnySettings.h"

#include <cmath>
#include <iterator>
#include <limits>

using namespace osgWaterReflect;

double AnyNumber::operator()()
{
    using Limits = std::numeric_limits<double>;
    const double limits[] = {0.0,
                             -0.0,
                             1.0,
                             64.0,
                             3.0,
                             -1.0,
                             Limits::quiet_NaN(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::denorm_min(),
                             Limits::max()};
    const double limit = limits[integer(0, static_cast<int>(std::size(limits)) - 1)];
    switch (integer(0, 3))
    {
    case 0:
        return limit;
    case 1:
        return std::nextafter(limit, once(2) ? 1e9 : -1e9);
    case 2:
        return std::pow(10.0, between(-30.0, 30.0));
    default:
        return between(0.0, 1.0);
    }
}

double AnyNumber::between(double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(_random);
}

int AnyNumber::integer(int low, int high)
{
    return std::uniform_int_distribution<int>(low, high)(_random);
}

ReflectionSettings anyReflection(AnyNumber& any)
{
    ReflectionSettings settings;
    settings.search = static_cast<Search>(any.integer(1, 4));
    settings.capture = static_cast<CaptureKind>(any.integer(1, 5));
    settings.thickness = any();
    if (any.once(2)) settings.stride = any.integer(-3, 70);
    return settings;
}

ViewSettings anyViewSettings(AnyNumber& any)
{
    ViewSettings settings;
    settings.guardBand = static_cast<GuardBandKind>(any.integer(1, 3));
    for (int changes = any.integer(1, 2); changes > 0; --changes)
        switch (any.integer(0, 4))
        {
        case 0:
            settings.captureScale = any();
            break;
        case 1:
            settings.maxExtraPixels = any();
            break;
        case 2:
            settings.guardBandShare = any();
            break;
        case 3:
            settings.traceScale = any();
            break;
        default:
            settings.frameTimeTarget = any();
            break;
        }
    return settings;
}

WaterOptics anyOptics(AnyNumber& any)
{
    WaterOptics optics;
    optics.refractiveIndex = any.once(2) ? any() : any.between(0.9, 4.1);
    optics.waterColour[any.integer(0, 2)] = static_cast<float>(any());
    return optics;
}

SurfaceDetail anyDetail(AnyNumber& any)
{
    SurfaceDetail detail;
    if (any.once(2)) detail.maxEdgePixels = any.once(2) ? any() : any.between(0.9, 1100.0);
    if (any.once(2)) detail.maxErrorPixels = any.once(2) ? any() : any.between(0.0, 70.0);
    detail.maxVertices = static_cast<unsigned int>(any.integer(900, 3000));
    return detail;
}

std::vector<TrochoidalWave> anyWaves(AnyNumber& any)
{
    std::vector<TrochoidalWave> waves(any.integer(0, 4));
    for (TrochoidalWave& wave : waves)
    {
        if (any.once(2)) wave.amplitude = any();
        if (any.once(2)) wave.length = any();
        if (any.once(4)) wave.directionDegrees = any();
        if (any.once(4)) wave.phase = any();
    }
    return waves;
}
