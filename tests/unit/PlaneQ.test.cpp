// The tracer's closed form against the paper's plane Q, built literally in double precision.

#include "support/Catch.h"

#include <osgWaterReflect/reference/PlaneQ.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace osgWaterReflect::reference;

namespace
{

// The tracer's step 3, as ray.glsl has it: windowZ and the other coordinate are linear along the
// segment from S to E.
struct ClosedForm
{
    double windowZ;
    double crossing;
};

ClosedForm closedForm(const glm::dvec3& s, const glm::dvec3& e, ImageLines lines, double line)
{
    const int along = static_cast<int>(lines);
    const double share = (line - s[along]) / (e[along] - s[along]);
    return {s.z + share * (e.z - s.z), s[1 - along] + share * (e[1 - along] - s[1 - along])};
}

struct Kind
{
    const char* name;
    glm::dmat4 clipFromEye;
};

std::vector<Kind> kinds()
{
    // Off-axis: the frustum's sides are not opposite. Oblique: its near plane leans, as a mirrored
    // capture's does, so that windowZ depends on x and y too; windowZ = 1 is still before infinity
    // everywhere.
    glm::dmat4 oblique = glm::perspective(0.8, 640.0 / 480.0, 0.3, 500.0);
    oblique[0][2] += 0.1;
    oblique[1][2] -= 0.2;
    oblique[2][2] -= 0.2;
    return {{"perspective", glm::perspective(0.8, 640.0 / 480.0, 0.3, 500.0)},
            {"deep perspective", glm::perspective(1.2, 640.0 / 480.0, 0.01, 10000.0)},
            {"off-axis", glm::frustum(-0.05, 0.3, -0.2, 0.04, 0.3, 500.0)},
            {"oblique near plane", oblique},
            {"orthographic", glm::ortho(-30.0, 20.0, -10.0, 25.0, -5.0, 300.0)}};
}

// The part of a ray inside the frustum, in double precision; false where there is none.
bool clip(const glm::dmat4& clipFromEye, const glm::dvec3& origin, const glm::dvec3& dir,
          double& first, double& last)
{
    const glm::dvec4 a = clipFromEye * glm::dvec4(origin, 1.0);
    const glm::dvec4 b = clipFromEye * glm::dvec4(dir, 0.0);
    first = 0.0;
    last = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1.0, 1.0})
        {
            const double inside = a.w + sign * a[axis];
            const double slope = b.w + sign * b[axis];
            if (slope < 0.0) last = std::min(last, -inside / slope);
            if (slope > 0.0) first = std::max(first, -inside / slope);
            if (slope == 0.0 && inside < 0.0) return false;
        }
    return first < last && std::isfinite(last);
}

} // namespace

// Falls when closedForm's windowZ is `s.z + share * e.z`, and when planeOnLine takes the sight of
// another column (`line + 1.0`).
TEST_CASE("the segment's linear windowZ is where the ray meets the paper's plane Q")
{
    std::mt19937 random(21);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    const int raysOfKind = 200000; // a million in all
    for (const Kind& kind : kinds())
    {
        const ImageGeometry image = {kind.clipFromEye, glm::dvec2(640.0, 480.0)};
        int compared = 0;
        double worstWindowZ = 0.0;
        double worstCrossing = 0.0;
        for (int i = 0; i < raysOfKind;)
        {
            // A visible point, at any depth, and any direction.
            const glm::dvec3 start(640.0 * unit(random), 480.0 * unit(random), unit(random));
            const glm::dvec3 origin = image.eyeFromWindow(start);
            const glm::dvec3 dir =
                glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            double first = 0.0;
            double last = 0.0;
            if (!clip(kind.clipFromEye, origin, dir, first, last)) continue;
            ++i;
            const glm::dvec3 s = image.windowFromEye(origin + first * dir);
            const glm::dvec3 e = image.windowFromEye(origin + last * dir);
            const ImageLines lines =
                std::abs(e.x - s.x) >= std::abs(e.y - s.y) ? ImageLines::COLUMNS : ImageLines::ROWS;
            const int along = static_cast<int>(lines);
            // One of the pixel centres that the segment passes, if it passes any.
            const double from = std::ceil(std::min(s[along], e[along]) - 0.5);
            const double to = std::floor(std::max(s[along], e[along]) - 0.5);
            if (from > to) continue;
            const double line = from + std::floor(unit(random) * (to - from + 1.0)) + 0.5;

            const double crossing = crossingOnLine(image, origin, dir, lines, line);
            // The depths seen at the two pixels cancel: any will do.
            const PlaneQ plane = planeOnLine(image, lines, line, crossing,
                                             glm::dvec2(unit(random), unit(random)) * 0.99);
            const glm::dvec3 met = image.windowFromEye(origin + plane.intersect(origin, dir) * dir);
            const ClosedForm closed = closedForm(s, e, lines, line);
            worstWindowZ = std::max(worstWindowZ, std::abs(met.z - closed.windowZ));
            worstCrossing = std::max(worstCrossing, std::abs(met[1 - along] - closed.crossing));
            ++compared;
        }
        INFO(kind.name << ": windowZ " << worstWindowZ << ", crossing " << worstCrossing
                       << " pixels, of " << compared << " rays");
        CHECK(compared > raysOfKind / 2);
        // Measured: 7e-10 and 8e-8 pixels at most, from rays that double precision sees badly: it
        // rounds by 1e-16 where unprojecting takes the difference of numbers far / near as large,
        // 1e6 in the deepest view. Ten times that.
        CHECK(worstWindowZ < 1e-8);
        CHECK(worstCrossing < 1e-6);
    }
}

// Falls when planeOnLine ignores `lines` (pixel() always takes columns).
TEST_CASE("in perspective the plane's normal is (1, 0, x), for rows (0, 1, y)")
{
    const ImageGeometry image = {glm::perspective(0.8, 640.0 / 480.0, 0.3, 500.0),
                                 glm::dvec2(640.0, 480.0)};
    for (double line : {0.5, 100.5, 320.5, 479.5})
        for (double crossing : {0.6, 33.3, 250.0, 400.9})
        {
            const auto check = [&](ImageLines lines, const glm::dvec3& window)
            {
                // Coordinates at a distance of 1 before the eye.
                const glm::dvec3 eye = image.eyeFromWindow(window);
                const int along = static_cast<int>(lines);
                glm::dvec3 expected(0.0, 0.0, eye[along] / -eye.z);
                expected[along] = 1.0;
                const PlaneQ plane =
                    planeOnLine(image, lines, line, crossing, glm::dvec2(0.2, 0.9));
                const double sine = glm::length(
                    glm::cross(glm::normalize(expected), glm::normalize(plane.normalEye)));
                CHECK(sine < 1e-9);
            };
            check(ImageLines::COLUMNS, glm::dvec3(line, crossing, 0.5));
            check(ImageLines::ROWS, glm::dvec3(crossing, line, 0.5));
        }
}
