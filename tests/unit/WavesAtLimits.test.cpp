// Waves of any value: they are refused with a message, or serve.

#include "support/AnySettings.h"
#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <cmath>

using namespace osgWaterReflect;

// Falls where setWaves takes a sum of steepness of 1, or waveDirection multiplies any direction by
// pi.
TEST_CASE("waves of any value are refused, or are finite everywhere and at any time")
{
    Chance chance(4);
    Refusals refusals;
    const osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    int taken = 0;
    int notFinite = 0;
    int silent = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const bool accepted = waves->setWaves(anyWaves(chance));
        silent += accepted != refusals.take().empty();
        taken += accepted;
        if (!accepted) continue;
        for (const double time : {0.0, 1e3, 1e9})
        {
            const osg::Vec2d place(chance.between(-2e5, 2e5), chance.between(-2e4, 2e4));
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
