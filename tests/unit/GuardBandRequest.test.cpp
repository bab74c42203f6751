// What several waters ask of one guard band.

#include "support/Catch.h"

#include <osgWaterReflect/band/GuardBandRequest.h>
#include <osgWaterReflect/band/ReflectedExtent.h>

#include <glm/gtc/matrix_transform.hpp>

#include <random>

using namespace osgWaterReflect;

// Breaks where largestSize() rounds the two sides of a fixed band up as one, or takes a band to be
// either fixed or adaptive: one water's sides may be those, another's these; and where band() does
// not cut what no texture can hold.
TEST_CASE("no band makes a larger image than is made room for")
{
    const std::vector<glm::dvec2> square = {{-30, -30}, {30, -30}, {30, 30}, {-30, 30}};
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
        ViewSettings adaptive;
        adaptive.guardBand = GuardBandKind::ADAPTIVE;
        adaptive.maxExtraPixels = i % 3 == 0 ? 0.0 : between(0.0, 3.0);
        ViewSettings fixed;
        fixed.guardBand = GuardBandKind::FIXED;
        fixed.guardBandShare = i % 4 == 0 ? 0.0 : between(0.0, 1.0);
        ReflectingSheet water;
        water.hull = &square;
        water.eyeFromSurface = glm::lookAt(eye, centre, up);
        const NdcExtent reflected = ReflectedRays(water, clipFromEye).extent(0.0);
        GuardBandRequest request;
        request.add(adaptive, reflected);
        request.add(fixed, reflected);

        const bool huge = i % 10 == 9;
        const glm::ivec2 viewSize(huge ? between(4000, 9000) : between(1, 300), between(1, 300));
        const NdcExtent scene = {-between(0, 5), between(0, 5), -between(0, 5), between(0, 5)};
        const glm::ivec2 size = widened(viewSize, request.band(scene, viewSize));
        const glm::ivec2 largest = request.largestSize(viewSize);
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

// Breaks where serves() asks of a fixed band, or of one that is closed, what it asks of none; and
// where it takes what was asked for in place of what is given.
TEST_CASE("a band serves where it reaches as far as the rays, whatever its kind")
{
    const glm::ivec2 viewSize(200, 100);
    const NdcExtent endless = {-100, 100, -100, 100};
    const NdcExtent rays = {-1.2, 1.2, -1.0, 1.5}; // 20 and 25 pixels beyond
    const auto serves =
        [&](GuardBandKind kind, double maxExtraPixels, double share, const NdcExtent& scene)
    {
        ViewSettings settings;
        settings.guardBand = kind;
        settings.maxExtraPixels = maxExtraPixels;
        settings.guardBandShare = share;
        GuardBandRequest request;
        request.add(settings, rays);
        return request.serves(rays, scene, viewSize);
    };
    CHECK(serves(GuardBandKind::ADAPTIVE, 1.0, 0.0, endless));
    CHECK_FALSE(serves(GuardBandKind::ADAPTIVE, 0.1, 0.0, endless));
    // Nearly none, none, and none by another name.
    for (const double closed : {1e-9, 0.0})
        CHECK_FALSE(serves(GuardBandKind::ADAPTIVE, closed, 0.0, endless));
    CHECK_FALSE(serves(GuardBandKind::NONE, 1.0, 1.0, endless));
    CHECK_FALSE(serves(GuardBandKind::FIXED, 1.0, 0.2, endless));
    CHECK(serves(GuardBandKind::FIXED, 1.0, 0.25, endless));
    // Where nothing is to be met, nothing is missed.
    for (const double extra : {1.0, 1e-9, 0.0})
        CHECK(serves(GuardBandKind::ADAPTIVE, extra, 0.0, NdcExtent()));
    CHECK(serves(GuardBandKind::NONE, 1.0, 0.0, NdcExtent()));
}
