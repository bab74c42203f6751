// Settings and waves of any value: each is refused with a message, or serves.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <cmath>
#include <limits>
#include <random>

using namespace osgWaterReflect;

namespace
{

// Numbers of every size, and what is none.
class AnyNumber
{
public:
    double operator()()
    {
        const double limits[] = {0.0,
                                 -0.0,
                                 1.0,
                                 64.0,
                                 3.0,
                                 -1.0,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::denorm_min(),
                                 std::numeric_limits<double>::max()};
        const int kind = std::uniform_int_distribution<int>(0, 3)(_random);
        const double limit =
            limits[std::uniform_int_distribution<std::size_t>(0, std::size(limits) - 1)(_random)];
        if (kind == 0) return limit;
        if (kind == 1)
            return std::nextafter(limit,
                                  std::uniform_int_distribution<int>(0, 1)(_random) ? 1e9 : -1e9);
        if (kind == 2)
            return std::pow(10.0, std::uniform_real_distribution<double>(-30, 30)(_random));
        return std::uniform_real_distribution<double>(0.0, 1.0)(_random);
    }

    std::mt19937& random() { return _random; }

private:
    std::mt19937 _random{4};
};

bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

// The ranges that the header states.
bool mayBe(const ReflectionSettings& s)
{
    return std::isfinite(s.thickness) && s.thickness > 0.0 && s.stride >= 1 && s.stride <= 64 &&
           s.captureScale > 0.0 && s.captureScale <= 1.0 && within(s.maxExtraPixels, 0.0, 3.0) &&
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
    int taken = 0;
    int otherwise = 0;
    for (int i = 0; i < 100000; ++i)
    {
        const ReflectionSettings before = water->getReflection();
        ReflectionSettings settings;
        // One or two members of any value.
        for (int changes = 0; changes < 2; ++changes)
            switch (std::uniform_int_distribution<int>(0, 6)(any.random()))
            {
            case 0:
                settings.thickness = any();
                break;
            case 1:
                settings.stride = std::uniform_int_distribution<int>(-3, 70)(any.random());
                break;
            case 2:
                settings.captureScale = any();
                break;
            case 3:
                settings.maxExtraPixels = any();
                break;
            case 4:
                settings.guardBandShare = any();
                break;
            case 5:
                settings.traceScale = any();
                break;
            default:
                settings.frameTimeTarget = any();
                break;
            }
        const bool accepted = water->setReflection(settings);
        const std::string message = refusals.take();
        taken += accepted;
        otherwise += accepted != mayBe(settings) || accepted != message.empty() ||
                     !(water->getReflection() == (accepted ? settings : before));
    }
    CHECK(taken > 20000);
    CHECK(taken < 80000);
    CHECK(otherwise == 0);
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
        std::vector<TrochoidalWave> list(std::uniform_int_distribution<int>(0, 4)(any.random()));
        for (TrochoidalWave& wave : list)
        {
            if (any.random()() % 2) wave.amplitude = any();
            if (any.random()() % 2) wave.length = any();
            if (any.random()() % 4 == 0) wave.directionDegrees = any();
            if (any.random()() % 4 == 0) wave.phase = any();
        }
        const bool accepted = waves->setWaves(list);
        silent += accepted != refusals.take().empty();
        taken += accepted;
        if (!accepted) continue;
        for (const double time : {0.0, 1e3, 1e9})
        {
            const osg::Vec2d place(any.random()() * 1e-4, any.random()() * 1e-5);
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
