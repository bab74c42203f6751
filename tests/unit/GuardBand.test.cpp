// The guard band: rectangles of the image, whole pixels, the widened projection.

#include "support/Catch.h"

#include <osgWaterReflect/band/GuardBand.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace osgWaterReflect;

namespace
{

const double INF = std::numeric_limits<double>::infinity();

bool equal(const NdcExtent& a, const NdcExtent& b)
{
    return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

bool equal(const GuardBand& a, const GuardBand& b)
{
    return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

double pixelCount(const glm::ivec2& size)
{
    return static_cast<double>(size.x) * size.y;
}

const std::vector<glm::dmat4> PROJECTIONS = {
    glm::perspective(0.8, 1.5, 0.1, 1000.0), glm::frustum(-0.03, 0.09, -0.02, 0.1, 0.1, 1000.0),
    glm::ortho(-3.0, 7.0, -2.0, 4.0, -10.0, 1000.0),
    // Rolled.
    glm::rotate(glm::perspective(0.8, 1.5, 0.1, 1000.0), 0.7, glm::dvec3(0, 0, 1))};

} // namespace

// Falls when unite() takes an empty rectangle's sides, or intersect() keeps sides that crossed.
TEST_CASE("an empty rectangle adds nothing, and what has nothing in common is empty")
{
    const NdcExtent view;
    const NdcExtent wide = {-3.0, 2.0, -1.5, INF};
    const NdcExtent beside = {1.5, 5.0, -1.0, 1.0};
    CHECK(NdcExtent::none().empty());
    CHECK_FALSE(view.empty());
    CHECK(equal(unite(NdcExtent::none(), wide), wide));
    CHECK(equal(unite(wide, NdcExtent::none()), wide));
    CHECK(equal(unite({5.0, 4.0, -1.0, 1.0}, wide), wide));
    CHECK(equal(unite(wide, beside), {-3.0, 5.0, -1.5, INF}));
    CHECK(equal(intersect(wide, beside), {1.5, 2.0, -1.0, 1.0}));
    CHECK(equal(intersect(view, beside), NdcExtent::none()));
    CHECK(equal(intersect(NdcExtent::none(), wide), NdcExtent::none()));
}

// Falls when ImageHull::add() counts what lies behind the eye as before it.
TEST_CASE("a box is seen where its points are")
{
    std::mt19937 random(1);
    const auto between = [&](double low, double high)
    { return std::uniform_real_distribution<double>(low, high)(random); };
    int finite = 0, infinite = 0;
    for (int i = 0; i < 600; ++i)
    {
        const glm::dmat4& projection = PROJECTIONS[i % PROJECTIONS.size()];
        const glm::dmat4 eyeFromLocal = glm::rotate(
            glm::translate(glm::dmat4(1.0),
                           glm::dvec3(between(-4, 4), between(-4, 4), between(-8, 2))),
            between(0, 6), glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), 1.5)));
        const osg::Vec3 low(between(-2, 0), between(-2, 0), between(-2, 0));
        const osg::BoundingBox box(low, low + osg::Vec3(between(0, 2), between(0, 2), 1.0));
        const NdcExtent extent = seenExtent(box, projection * eyeFromLocal);

        // Points on its edges, the nearest to the eye's plane among them.
        NdcExtent seen = NdcExtent::none();
        const auto see = [&seen](const glm::dvec4& clip)
        {
            if (!(clip.w > 0.0)) return;
            const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
            seen = unite(seen, {ndc.x, ndc.x, ndc.y, ndc.y});
        };
        const auto corner = [&](unsigned int index)
        {
            const osg::Vec3 c = box.corner(index);
            return projection * eyeFromLocal * glm::dvec4(c.x(), c.y(), c.z(), 1.0);
        };
        for (unsigned int a = 0; a < 8; ++a)
            for (unsigned int b = 0; b < 8; ++b) // any two: insides of faces and box, too
            {
                const glm::dvec4 clipA = corner(a);
                const glm::dvec4 clipB = corner(b);
                for (int step = 0; step <= 10; ++step)
                    see(glm::mix(clipA, clipB, step / 10.0));
                if (clipA.w > 0.0 && clipB.w <= 0.0)
                    see(glm::mix(clipA, clipB, clipA.w / (clipA.w - clipB.w) * (1.0 - 1e-9)));
            }

        REQUIRE(extent.empty() == seen.empty());
        if (seen.empty()) continue;
        const double computed[] = {-extent.left, extent.right, -extent.bottom, extent.top};
        const double found[] = {-seen.left, seen.right, -seen.bottom, seen.top};
        for (int side = 0; side < 4; ++side)
        {
            // A box that comes to a billionth of its size of the eye's plane.
            if (std::isinf(computed[side]))
                REQUIRE(found[side] > 1e3);
            else
                REQUIRE(found[side] == Approx(computed[side]).epsilon(1e-9).margin(1e-9));
            ++(std::isinf(computed[side]) ? infinite : finite);
        }
    }
    CHECK(finite > 500);
    CHECK(infinite > 100);
}

TEST_CASE("a box around the eye is seen everywhere, one behind it and an invalid one nowhere")
{
    const glm::dmat4& clipFromEye = PROJECTIONS[0];
    CHECK(equal(seenExtent(osg::BoundingBox(-1, -1, -1, 1, 1, 1), clipFromEye),
                {-INF, INF, -INF, INF}));
    CHECK(equal(seenExtent(osg::BoundingBox(-1, -1, 1, 1, 1, 2), clipFromEye), NdcExtent::none()));
    CHECK(equal(seenExtent(osg::BoundingBox(), clipFromEye), NdcExtent::none()));
    // A wall along the way to the right goes on to the right alone.
    const NdcExtent wall = seenExtent(osg::BoundingBox(1, -1, -20, 2, -0.5, 5), clipFromEye);
    CHECK(wall.left > 0.0);
    CHECK(wall.right == INF);
    CHECK(wall.bottom == -INF);
    CHECK(wall.top < 0.0);
}

// Falls when bandFor() forgets ROUNDING, or takes whole pixels down (floor) before the ceiling.
TEST_CASE("a band has the pixels that are asked for, and none for a rounding error")
{
    const glm::ivec2 size(640, 480);
    CHECK(equal(bandFor(NdcExtent{}, size, 1.0), GuardBand{}));
    CHECK(equal(bandFor(NdcExtent{}, size, 0.0), GuardBand{}));
    CHECK(equal(bandFor(NdcExtent::none(), size, 1.0), GuardBand{}));
    CHECK(equal(bandFor({-0.5, 0.5, -0.5, 0.5}, size, 1.0), GuardBand{}));
    const double tiny = 1.0 + 1e-12;
    CHECK(equal(bandFor({-tiny, tiny, -tiny, tiny}, size, 1.0), GuardBand{}));

    const auto ndc = [](double pixels, int across) { return 1.0 + 2.0 * pixels / across; };
    const NdcExtent needed = {-ndc(3.0, 640), ndc(3.1, 640), -ndc(0.5, 480), ndc(100.0, 480)};
    CHECK(equal(bandFor(needed, size, 1.0), {3, 4, 1, 100}));
    CHECK(reaches({3, 4, 1, 100}, needed, size));
    for (const GuardBand& less :
         {GuardBand{2, 4, 1, 100}, {3, 3, 1, 100}, {3, 4, 0, 100}, {3, 4, 1, 99}})
        CHECK_FALSE(reaches(less, needed, size));
}

// Falls when cutFactor() leaves out the corners (a = 0), or bandFor() rounds up after it.
TEST_CASE("a band keeps to its ceiling, with one factor for all sides")
{
    std::mt19937 random(2);
    const auto between = [&](double low, double high)
    { return std::uniform_real_distribution<double>(low, high)(random); };
    int cuts = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const glm::ivec2 size(between(1, 3000), between(1, 3000));
        const double extra = i % 3 == 0 ? std::floor(between(0, 4)) : between(0.0, 3.0);
        NdcExtent needed = {-between(1, 3), between(1, 3), -between(1, 3), between(1, 3)};
        if (i % 5 == 0) needed.left = -1.0;
        if (i % 7 == 0) needed.top = INF;
        if (i % 11 == 0) needed = {-INF, INF, -INF, INF};
        const GuardBand band = bandFor(needed, size, extra);
        const bool cut = !reaches(band, needed, size);
        const GuardBand whole = bandFor(needed, size, 1e300);
        const double limit = (1.0 + extra) * pixelCount(size);
        INFO(size.x << " x " << size.y << ", extra " << extra);
        REQUIRE(std::min({band.left, band.right, band.bottom, band.top}) >= 0);
        REQUIRE(pixelCount(widened(size, band)) <= limit);
        if (!cut) REQUIRE(equal(band, whole));
        if (!cut || i % 7 == 0 || i % 11 == 0) continue;
        ++cuts;
        REQUIRE(pixelCount(widened(size, whole)) > limit);
        // No pixel more on every side that has one.
        const glm::ivec2 more = widened(size, band) + glm::ivec2(2, 2);
        REQUIRE(pixelCount(more) > limit * (1.0 - 1e-9));
        // One factor, but for whole pixels; no side beyond what the ceiling leaves it alone.
        const double part[] = {band.left / std::min<double>(whole.left, extra * size.x),
                               band.right / std::min<double>(whole.right, extra * size.x),
                               band.bottom / std::min<double>(whole.bottom, extra * size.y),
                               band.top / std::min<double>(whole.top, extra * size.y)};
        for (double a : part)
            for (double b : part)
                if (std::isfinite(a) && std::isfinite(b))
                    REQUIRE(std::abs(a - b) <=
                            1.0 / std::min({whole.right, whole.bottom, whole.top,
                                            whole.left > 0 ? whole.left : whole.right}) +
                                2.0 / (1e-9 + extra * std::min(size.x, size.y)));
    }
    CHECK(cuts > 1000);

    // Every side infinite: the extra pixels are shared, an even frame about the view. A pixel that
    // rounding may make one too many is left out.
    CHECK(equal(bandFor({-INF, INF, -INF, INF}, {400, 400}, 3.0), {199, 199, 199, 199}));
    // One side alone gets them all.
    CHECK(equal(bandFor({-1.0, INF, -1.0, 1.0}, {400, 400}, 0.5), {0, 199, 0, 0}));
}

// Falls when widened() shifts by left + right, or adds the shift to the last column alone.
TEST_CASE("the widened image has the view's pixels where they were")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    const glm::ivec2 size(640, 480);
    const GuardBand band = {13, 200, 7, 91};
    const glm::ivec2 wideSize = widened(size, band);
    CHECK(wideSize == glm::ivec2(853, 578));
    for (const glm::dmat4& clipFromEye : PROJECTIONS)
    {
        const glm::dmat4 wide = widened(clipFromEye, size, band);
        for (int i = 0; i < 200; ++i)
        {
            const glm::dvec3 p(within(random), within(random),
                               -1.0 - 50.0 * std::abs(within(random)));
            const glm::dvec4 a = clipFromEye * glm::dvec4(p, 1.0);
            const glm::dvec4 b = wide * glm::dvec4(p, 1.0);
            const glm::dvec2 pixelA = (0.5 * glm::dvec2(a) / a.w + 0.5) * glm::dvec2(size);
            const glm::dvec2 pixelB = (0.5 * glm::dvec2(b) / b.w + 0.5) * glm::dvec2(wideSize);
            const glm::dvec2 expected = pixelA + glm::dvec2(band.left, band.bottom);
            REQUIRE(glm::distance(pixelB, expected) < 1e-9); // [pixels] rounding
            REQUIRE(b.z == a.z);
            REQUIRE(b.w == a.w);
        }
        CHECK(widened(clipFromEye, size, GuardBand{}) == clipFromEye);
    }
}
