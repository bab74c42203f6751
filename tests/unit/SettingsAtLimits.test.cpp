// Settings and waves of any value: each is refused with a message, or serves.

#include "support/AnySettings.h"
#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <cmath>

using namespace osgWaterReflect;

namespace
{

bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

// The ranges that the header states.
bool mayBe(const ReflectionSettings& s)
{
    return std::isfinite(s.thickness) && s.thickness > 0.0 && s.stride >= 1 && s.stride <= 64;
}

bool mayBe(const ViewSettings& s)
{
    return s.captureScale > 0.0 && s.captureScale <= 1.0 && within(s.maxExtraPixels, 0.0, 3.0) &&
           within(s.guardBandShare, 0.0, 1.0) && s.traceScale > 0.0 && s.traceScale <= 1.0 &&
           std::isfinite(s.frameTimeTarget) && s.frameTimeTarget >= 0.0;
}

} // namespace

// Falls with any range that check() widens, narrows or leaves out.
TEST_CASE("of a hundred thousand random settings each is refused by name, or is within its range")
{
    const osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(0, 0, 0), osg::Vec3(10, 0, 0), osg::Vec3(0, 10, 0));
    AnyNumber any;
    Refusals refusals;
    const auto tryAny = [&](auto anySettings, auto set, auto get)
    {
        int taken = 0;
        int otherwise = 0;
        for (int i = 0; i < 50000; ++i)
        {
            const auto before = get();
            const auto settings = anySettings(any);
            const bool accepted = set(settings);
            const std::string message = refusals.take();
            taken += accepted;
            otherwise += accepted != mayBe(settings) || accepted != message.empty() ||
                         !(get() == (accepted ? settings : before));
        }
        CHECK(taken > 10000);
        CHECK(taken < 40000);
        CHECK(otherwise == 0);
    };
    tryAny(
        anyReflection, [&](const auto& settings) { return water->setReflection(settings); },
        [&] { return water->getReflection(); });
    tryAny(
        anyViewSettings, [&](const auto& settings) { return water->setViewSettings(settings); },
        [&] { return water->getViewSettings(); });
}

// Falls where setWaves takes a sum of steepness of 1, or waveDirection multiplies any direction by
// pi.
TEST_CASE("waves of any value are refused, or are finite everywhere and at any time")
{
    AnyNumber any;
    Refusals refusals;
    const osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    int taken = 0;
    int notFinite = 0;
    int silent = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const bool accepted = waves->setWaves(anyWaves(any));
        silent += accepted != refusals.take().empty();
        taken += accepted;
        if (!accepted) continue;
        for (const double time : {0.0, 1e3, 1e9})
        {
            const osg::Vec2d place(any.between(-2e5, 2e5), any.between(-2e4, 2e4));
            const osg::Vec3d normal = waves->getNormal(place, time);
            const double values[] = {waves->getHeight(place, time),
                                     normal.x(),
                                     normal.y(),
                                     normal.z(),
                                     waves->getAmplitude(),
                                     waves->getMaxSlope(),
                                     waves->getRmsSlope(),
                                     waves->getChordError(1.0)};
            for (const double value : values)
                notFinite += !std::isfinite(value);
        }
    }
    CHECK(taken > 2000);
    CHECK(notFinite == 0);
    CHECK(silent == 0);
}
