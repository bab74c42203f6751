// What several waters ask of one guard band.

#include "support/Catch.h"

#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/capture/BandDemand.h>
#include <osgWaterReflect/surface/StillWater.h>

#include <glm/gtc/matrix_transform.hpp>

#include <random>

using namespace osgWaterReflect;

// Breaks where largestSize() rounds the two sides of a fixed band up as one, or takes a band to be
// either fixed or adaptive: one water's sides may be those, another's these; and where band() does
// not cut what no texture can hold.
TEST_CASE("no band makes a larger image than is made room for")
{
    const osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(60, 0, 0), osg::Vec3(0, 60, 0));
    const auto sheets = StillWater::createSheets(*water->getDrawable(0));
    const glm::dmat4 clipFromEye = glm::perspective(0.8, 1.5, 0.1, 1000.0);
    std::mt19937 random(1);
    const auto between = [&](double low, double high)
    { return std::uniform_real_distribution<double>(low, high)(random); };
    int reached = 0;
    int wide = 0;
    for (int i = 0; i < 20000; ++i)
    {
        // From above the water, rolled, so that reflected rays leave by any side.
        const glm::dvec3 eye(between(-20, 20), between(-20, 20), between(0.5, 20));
        const glm::dvec3 centre(between(-20, 20), between(-20, 20), 0.0);
        const glm::dvec3 up(between(-1, 1), between(-1, 1), 1.0);
        ReflectionSettings adaptive;
        adaptive.guardBand = GuardBandKind::ADAPTIVE;
        adaptive.maxExtraPixels = i % 3 == 0 ? 0.0 : between(0.0, 3.0);
        ReflectionSettings fixed;
        fixed.guardBand = GuardBandKind::FIXED;
        fixed.guardBandShare = i % 4 == 0 ? 0.0 : between(0.0, 1.0);
        const glm::dmat4 eyeFromLocal = glm::lookAt(eye, centre, up);
        const BandDemand demand(
            {{water, &sheets, eyeFromLocal, adaptive}, {water, &sheets, eyeFromLocal, fixed}},
            clipFromEye, 0.0);

        const bool huge = i % 10 == 9;
        const glm::ivec2 viewSize(huge ? between(4000, 9000) : between(1, 300), between(1, 300));
        const NdcExtent scene = {-between(0, 5), between(0, 5), -between(0, 5), between(0, 5)};
        const glm::ivec2 size = widened(viewSize, demand.band(scene, viewSize));
        const glm::ivec2 largest = demand.largestSize(viewSize);
        INFO(viewSize.x << " x " << viewSize.y << ", extra " << adaptive.maxExtraPixels
                        << ", share " << fixed.guardBandShare);
        REQUIRE(largest.x <= 16384); // what a texture may be wide
        REQUIRE(size.x <= largest.x);
        REQUIRE(size.y <= largest.y);
        reached += size == largest;
        const double factor = 1.0 + std::max(adaptive.maxExtraPixels, 2.0 * fixed.guardBandShare);
        wide += size.x > std::ceil(factor * viewSize.x) + 1 ||
                size.y > std::ceil(factor * viewSize.y) + 1;
    }
    CHECK(reached > 1000); // fixed bands alone
    CHECK(wide > 100);     // bands of both kinds
}
