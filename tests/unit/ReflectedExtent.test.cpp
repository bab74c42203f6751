// How far reflected rays go in the image: against following very many of them.

#include "support/Catch.h"

#include <osgWaterReflect/band/ReflectedExtent.h>
#include <osgWaterReflect/surface/ConvexHull.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

using namespace osgWaterReflect;

namespace
{

const double PI = 3.14159265358979323846;
const double INF = std::numeric_limits<double>::infinity();
// [1] of the extent: an orthographic image half a unit high, 1e7 units along a ray.
const double ROUNDING = 1e-8;
const std::vector<glm::dvec2> LAKE = {{-60, 5}, {60, 5}, {60, 200}, {-60, 200}};

// What one frame of the sweep sees.
struct Frame
{
    std::string name;
    std::vector<glm::dvec2> outline = LAKE; // surface space
    glm::dmat4 eyeFromSurface{1.0};
    glm::dmat4 clipFromEye{1.0};
    double amplitude = 0.0;
    double slope = 0.0;
    double side = 1.0;
};

NdcExtent extentOf(const Frame& frame)
{
    const std::vector<glm::dvec2> hull = convexHull(frame.outline);
    return ReflectedRays({&hull, frame.eyeFromSurface, frame.amplitude, frame.side},
                         frame.clipFromEye)
        .extent(frame.slope);
}

// An eye at (0, 0, height) over the surface that looks along y, pitched down and rolled.
glm::dmat4 eyeFromSurface(double height, double pitchDegrees, double rollDegrees)
{
    const double pitch = glm::radians(pitchDegrees);
    const glm::dvec3 eye(0.0, 0.0, height);
    const glm::dvec3 along(0.0, std::cos(pitch), -std::sin(pitch));
    const glm::dvec3 up(0.0, std::sin(pitch), std::cos(pitch));
    return glm::rotate(glm::dmat4(1.0), glm::radians(rollDegrees), glm::dvec3(0, 0, 1)) *
           glm::lookAt(eye, eye + along, up);
}

// Half the field of view, across and up.
glm::dmat4 perspective(double halfDegrees, double aspect = 4.0 / 3.0, double shift = 0.0)
{
    const double half = 0.1 * std::tan(glm::radians(halfDegrees));
    const double wide = aspect * half;
    return glm::frustum((shift - 1.0) * wide, (shift + 1.0) * wide, (-0.5 * shift - 1.0) * half,
                        (-0.5 * shift + 1.0) * half, 0.1, 1000.0);
}

bool contains(const std::vector<glm::dvec2>& outline, const glm::dvec2& p)
{
    bool inside = false;
    for (std::size_t i = 0, last = outline.size() - 1; i < outline.size(); last = i++)
    {
        const glm::dvec2& a = outline[i];
        const glm::dvec2& b = outline[last];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

// Follows rays one by one and remembers how far their images went.
class Sweep
{
public:
    explicit Sweep(const Frame& frame) :
        _frame(frame),
        _normalMatrix(glm::transpose(glm::inverse(glm::dmat3(frame.eyeFromSurface)))),
        _still(frame.side * glm::normalize(_normalMatrix[2])),
        _orthographic(frame.clipFromEye[3][3] != 0.0)
    {
        const int layers = frame.amplitude > 0.0 ? 8 : 0;
        for (int i = -layers; i <= layers; ++i)
        {
            const double z = layers > 0 ? frame.amplitude * i / layers : 0.0;
            sweepInside(z);
            sweepOutline(z);
        }
    }

    NdcExtent reached;
    int rays = 0;
    int points = 0;

private:
    glm::dvec3 eyePoint(const glm::dvec3& surface) const
    {
        return glm::dvec3(_frame.eyeFromSurface * glm::dvec4(surface, 1.0));
    }

    void sweepInside(double z)
    {
        const glm::dmat4 surfaceFromClip = glm::inverse(_frame.clipFromEye * _frame.eyeFromSurface);
        const int steps = 12;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j)
            {
                const glm::dvec2 ndc(2.0 * i / steps - 1.0, 2.0 * j / steps - 1.0);
                const glm::dvec4 n = surfaceFromClip * glm::dvec4(ndc, -1.0, 1.0);
                const glm::dvec4 f = surfaceFromClip * glm::dvec4(ndc, 1.0, 1.0);
                const glm::dvec3 a = glm::dvec3(n) / n.w;
                const glm::dvec3 along = glm::dvec3(f) / f.w - a;
                const glm::dvec3 p = a + (z - a.z) / along.z * along;
                if (contains(_frame.outline, glm::dvec2(p)))
                    sweepNormals(p, i % steps == 0 && j % steps == 0 ? 360 : 24);
            }
    }

    // Corners, what lies between, and where the sides of the view cut the outline.
    void sweepOutline(double z)
    {
        const glm::dmat4 clipFromSurface = _frame.clipFromEye * _frame.eyeFromSurface;
        for (std::size_t i = 0, last = _frame.outline.size() - 1; i < _frame.outline.size();
             last = i++)
        {
            const glm::dvec3 a(_frame.outline[last], z);
            const glm::dvec3 b(_frame.outline[i], z);
            const glm::dvec4 clipA = clipFromSurface * glm::dvec4(a, 1.0);
            const glm::dvec4 clipB = clipFromSurface * glm::dvec4(b, 1.0);
            std::vector<double> parts = {0.0, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0};
            for (int axis = 0; axis < 2; ++axis)
                for (double sign : {-1.0, 1.0})
                {
                    const double atA = clipA.w + sign * clipA[axis];
                    const double atB = clipB.w + sign * clipB[axis];
                    if (atA * atB < 0.0) parts.push_back(atA / (atA - atB));
                }
            for (double part : parts)
                sweepNormals(glm::mix(a, b, part), 180);
        }
    }

    void sweepNormals(const glm::dvec3& surface, int turns)
    {
        const glm::dvec3 p = eyePoint(surface);
        const glm::dvec4 clip = _frame.clipFromEye * glm::dvec4(p, 1.0);
        // A rounding error beside the view is in it.
        const double w = clip.w * (1.0 + 1e-12);
        if (!(clip.w > 0.0 && std::abs(clip.x) <= w && std::abs(clip.y) <= w)) return;
        ++points;
        follow(p, {0.0, 0.0});
        for (double radius : {1.0, 0.9, 0.5})
            for (int i = 0; i < turns && _frame.slope > 0.0; ++i)
                follow(p, radius * _frame.slope *
                              glm::dvec2(std::cos(2.0 * PI * i / turns),
                                         std::sin(2.0 * PI * i / turns)));
    }

    // As shadeWater() of shade.glsl does.
    void follow(const glm::dvec3& p, const glm::dvec2& slope)
    {
        const glm::dvec3 toEye = _orthographic ? glm::dvec3(0, 0, 1) : glm::normalize(-p);
        glm::dvec3 normal =
            _frame.side * glm::normalize(_normalMatrix * glm::dvec3(-slope.x, -slope.y, 1.0));
        const double facing = glm::dot(normal, toEye);
        if (facing < 0.0) normal = glm::normalize(normal - facing * toEye);
        glm::dvec3 ray = glm::reflect(-toEye, normal);
        ray -= 2.0 * std::min(glm::dot(ray, _still), 0.0) * _still;
        reach(_frame.clipFromEye * glm::dvec4(p, 1.0), _frame.clipFromEye * glm::dvec4(ray, 0.0));
        ++rays;
    }

    // Where origin + t direction is seen, t growing from 0 to where the eye's plane or infinity is.
    void reach(const glm::dvec4& origin, const glm::dvec4& direction)
    {
        if (direction.w > 0.0) return see(direction);
        const double last = direction.w < 0.0 ? -origin.w / direction.w : 1e7;
        see(origin + last * (1.0 - 1e-9) * direction);
    }

    void see(const glm::dvec4& clip)
    {
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        reached.left = std::min(reached.left, ndc.x);
        reached.right = std::max(reached.right, ndc.x);
        reached.bottom = std::min(reached.bottom, ndc.y);
        reached.top = std::max(reached.top, ndc.y);
    }

    const Frame& _frame;
    glm::dmat3 _normalMatrix;
    glm::dvec3 _still;
    bool _orthographic;
};

// Where the sweep's rays came to, and the extent, as distances from the view's centre: left, right,
// bottom, top.
glm::dvec4 distances(const NdcExtent& extent)
{
    return {-extent.left, extent.right, -extent.bottom, extent.top};
}

class RandomFrames
{
public:
    explicit RandomFrames(unsigned int seed) : _random(seed) {}

    Frame next()
    {
        const double height = oneOf({0.5, 1.7, 30.0});
        const double pitch = oneOf({0.0, between(0.0, 60.0)});
        const double roll = oneOf({0.0, 90.0, between(-180.0, 180.0)});
        const double half = between(8.0, 40.0);
        const double aspect = between(0.5, 2.5);
        Frame frame;
        frame.clipFromEye = perspective(half, aspect, oneOf({0.0, between(-1.0, 1.0)}));
        if (oneOf({0, 0, 0, 1}) == 1)
            frame.clipFromEye = glm::ortho(-aspect * height, aspect * height, -0.7 * height,
                                           1.1 * height, 0.1, 1000.0);
        const glm::dmat4 frameOfSurface = surfaceFrame();
        frame.eyeFromSurface = eyeFromSurface(height, pitch, roll) * frameOfSurface;
        frame.side = frameOfSurface[2].z < 0.0 ? -1.0 : 1.0;
        frame.slope = oneOf({0.0, 0.05, 0.1, 0.2});
        frame.amplitude = frame.slope > 0.0 ? oneOf({0.0, 0.1, 0.4, 0.7}) : 0.0;
        const double size = oneOf({1.0, 2.0, 1000.0}) * height;
        const glm::dvec2 centre(oneOf({0.0, between(-2.0, 2.0)}) * height,
                                between(-1.0, 20.0) * height);
        frame.outline = {centre - size, centre + glm::dvec2(size, -size), centre + size,
                         centre + glm::dvec2(-size, size)};
        std::ostringstream name;
        name << "height " << height << ", pitch " << pitch << ", roll " << roll << ", half field "
             << half << ", slope " << frame.slope << ", amplitude " << frame.amplitude << ", side "
             << frame.side << ", lake of " << size << " at " << centre.x << " " << centre.y
             << (frame.clipFromEye[3][3] != 0.0 ? ", orthographic" : "");
        frame.name = name.str();
        return frame;
    }

private:
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(_random);
    }

    double oneOf(const std::vector<double>& values)
    {
        return values[std::uniform_int_distribution<std::size_t>(0, values.size() - 1)(_random)];
    }

    // Level and as it is, mostly; else scaled, scaled by each axis, mirrored, seen from below,
    // tilted.
    glm::dmat4 surfaceFrame()
    {
        const glm::dmat4 same(1.0);
        switch (static_cast<int>(between(0.0, 12.0)))
        {
        case 0:
            return glm::scale(same, glm::dvec3(2.0));
        case 1:
            return glm::scale(same, glm::dvec3(2.0, 1.0, 0.5));
        case 2:
            return glm::scale(same, glm::dvec3(-1.0, 1.0, 1.0));
        case 3:
            return glm::scale(same, glm::dvec3(1.0, 1.0, -1.0));
        case 4:
            return glm::rotate(same, PI, glm::dvec3(0, 1, 0));
        case 5:
            return glm::rotate(same, between(-0.5, 0.5), glm::dvec3(0.6, 0.8, 0));
        default:
            return same;
        }
    }

    std::mt19937 _random;
};

} // namespace

// Falls when ReflectedRays takes the still normal alone, 8 normals, the bare slope or the
// sheet's side for +1; when SeenOutline forgets the amplitude, or the walls between crests and
// troughs; when rays that a normal turned from the eye would reflect are followed, too.
TEST_CASE("no reflected ray leaves the extent, and little of it lies idle")
{
    RandomFrames frames(1);
    std::vector<double> idle;
    for (int i = 0; i < 500; ++i)
    {
        const Frame frame = frames.next();
        INFO(frame.name);
        const NdcExtent extent = extentOf(frame);
        const Sweep sweep(frame);
        const glm::dvec4 computed = distances(extent);
        const glm::dvec4 swept = distances(sweep.reached);
        for (int side = 0; side < 4; ++side)
        {
            INFO("side " << side << ": computed " << computed[side] << ", swept " << swept[side]);
            REQUIRE(computed[side] >= 1.0);
            REQUIRE(swept[side] <= computed[side] * (1.0 + ROUNDING));
            // Farther than that, the ceiling decides.
            if (sweep.points == 0 || swept[side] > 10.0) continue;
            REQUIRE(computed[side] < 12.0);
            idle.push_back(1.0 - swept[side] / computed[side]);
        }
    }
    std::sort(idle.begin(), idle.end());
    INFO(idle.size() << " sides, 90 % " << idle[idle.size() * 9 / 10] << ", 99 % "
                     << idle[idle.size() * 99 / 100] << ", worst " << idle.back());
    CHECK(idle.size() > 1000);
    CHECK(idle[idle.size() * 99 / 100] < 0.01);
    // Crests as high as the eye, of which the sweep takes 17 layers.
    CHECK(idle.back() < 0.1);
}

// What lies in the hull's bays is taken for water.
TEST_CASE("no ray that a concave lake reflects leaves the extent")
{
    RandomFrames frames(2);
    for (int i = 0; i < 150; ++i)
    {
        Frame frame = frames.next();
        INFO(frame.name);
        const glm::dvec2 low = frame.outline[0];
        const glm::dvec2 size = frame.outline[2] - low;
        frame.outline.clear();
        for (const glm::dvec2& corner :
             {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 0.2), glm::dvec2(0.3, 0.3),
              glm::dvec2(0.2, 1), glm::dvec2(0, 1)})
            frame.outline.push_back(low + corner * size);
        const glm::dvec4 computed = distances(extentOf(frame));
        const glm::dvec4 swept = distances(Sweep(frame).reached);
        for (int side = 0; side < 4; ++side)
            REQUIRE(swept[side] <= computed[side] * (1.0 + ROUNDING));
    }
}

TEST_CASE(
    "calm water asks for tan(b + 2p) / tan b of the height and cos b / cos(b + 2p) of the width")
{
    Frame frame;
    frame.outline = {{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}};
    for (double half : {5.0, 23.0, 40.0})
        for (double pitch : {0.0, 0.1, 8.6, 20.0})
        {
            INFO("half field " << half << ", pitch " << pitch);
            const double b = glm::radians(half);
            const double p = glm::radians(pitch);
            frame.eyeFromSurface = eyeFromSurface(1.7, pitch, 0.0);
            frame.clipFromEye = perspective(half);
            const NdcExtent extent = extentOf(frame);
            // Double precision of places seen to a millionth of the lake's size.
            const Approx width = Approx(std::cos(b) / std::cos(b + 2.0 * p)).epsilon(1e-9);
            CHECK(extent.top == Approx(std::tan(b + 2.0 * p) / std::tan(b)).epsilon(1e-9));
            CHECK(extent.bottom == -1.0);
            CHECK(extent.right == width);
            CHECK(-extent.left == width);
        }
    // Beyond 90 degrees what the bottom of the view reflects lies behind the eye.
    frame.eyeFromSurface = eyeFromSurface(1.7, 35.0, 0.0);
    frame.clipFromEye = perspective(23.0);
    const NdcExtent extent = extentOf(frame);
    CHECK(extent.top == INF);
    CHECK(extent.right == INF);
    CHECK(extent.left == -INF);
    CHECK(extent.bottom == -1.0);
}

// Falls when imageOf() keeps the rounding.
TEST_CASE("an orthographic view's rays go on for ever, but to no side that they do not lean to")
{
    Frame frame;
    frame.clipFromEye = glm::ortho(-10.0, 10.0, -10.0, 10.0, 0.1, 1000.0);
    frame.eyeFromSurface = eyeFromSurface(20.0, 30.0, 0.0);
    NdcExtent extent = extentOf(frame);
    CHECK(extent.left == -1.0);
    CHECK(extent.right == 1.0);
    CHECK(extent.bottom == -1.0);
    CHECK(extent.top == INF);

    // Straight down, a ray comes straight back.
    frame.outline = {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
    frame.eyeFromSurface =
        glm::lookAt(glm::dvec3(0, 0, 20), glm::dvec3(0, 0, 0), glm::dvec3(0.6, 0.8, 0.0));
    CHECK(distances(extentOf(frame)) == glm::dvec4(1.0));
    frame.slope = 0.01;
    CHECK(distances(extentOf(frame)) == glm::dvec4(INF));
}

TEST_CASE("the extent follows the camera without jumps")
{
    RandomFrames frames(3);
    for (int i = 0; i < 1000; ++i)
    {
        Frame frame = frames.next();
        INFO(frame.name);
        const glm::dvec4 before = distances(extentOf(frame));
        frame.eyeFromSurface =
            glm::rotate(glm::dmat4(1.0), 1e-7, glm::dvec3(0.6, 0.0, 0.8)) * frame.eyeFromSurface;
        const glm::dvec4 after = distances(extentOf(frame));
        const bool perspective = frame.clipFromEye[3][3] == 0.0;
        for (int side = 0; side < 4 && perspective; ++side)
        {
            INFO("side " << side << ": " << before[side] << ", " << after[side]);
            // The image of an angle grows with the square of how far out it lies; narrow fields,
            // tilted normals and the horizon's neighbourhood magnify it a hundred times.
            const double square = before[side] * before[side];
            if (square < 100.0) CHECK(std::abs(after[side] - before[side]) < 1e-5 * square);
        }
    }
}

TEST_CASE("where no water is seen the extent is the view, and it is a number whatever is given")
{
    Frame frame;
    frame.clipFromEye = perspective(23.0);
    frame.slope = 0.1;
    const auto isView = [&frame]() { return distances(extentOf(frame)) == glm::dvec4(1.0); };
    frame.eyeFromSurface = eyeFromSurface(1.7, -40.0, 0.0);
    CHECK(isView()); // above the horizon
    frame.eyeFromSurface =
        glm::rotate(glm::dmat4(1.0), PI, glm::dvec3(0, 1, 0)) * eyeFromSurface(1.7, 10.0, 0.0);
    CHECK(isView()); // behind the eye
    frame.eyeFromSurface = eyeFromSurface(1.7, 10.0, 0.0);
    CHECK_FALSE(isView());
    frame.outline.clear();
    CHECK(isView());

    const std::vector<std::vector<glm::dvec2>> outlines = {
        {},
        {{0, 5}},
        {{0, 5}, {0, 5}},
        {{-3, 5}, {3, 5}},
        {{0, 0}, {0, 9}},
        LAKE,
        {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}}};
    const std::vector<glm::dmat4> projections = {
        perspective(23.0), glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 10.0), glm::dmat4(0.0)};
    for (const std::vector<glm::dvec2>& outline : outlines)
        for (double height : {0.0, 1e-300, 0.1, 1.7})
            for (double pitch : {0.0, 30.0, 90.0})
                for (double scale : {1.0, 0.0})
                    for (double slope : {0.0, 0.1, 1e9, INF})
                        for (double amplitude : {0.0, 0.1})
                            for (const glm::dmat4& projection : projections)
                            {
                                frame.outline = outline;
                                frame.eyeFromSurface =
                                    eyeFromSurface(height, pitch, 0.0) *
                                    glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
                                frame.clipFromEye = projection;
                                frame.slope = slope;
                                frame.amplitude = amplitude;
                                const glm::dvec4 computed = distances(extentOf(frame));
                                for (int side = 0; side < 4; ++side)
                                    REQUIRE(computed[side] >= 1.0);
                            }
}

// Printed by `test_unit "[.timing]"`.
TEST_CASE("how long an extent takes", "[.timing]")
{
    RandomFrames frames(4);
    std::vector<double> microseconds;
    for (int i = 0; i < 2000; ++i)
    {
        const Frame frame = frames.next();
        const std::vector<glm::dvec2> hull = convexHull(frame.outline);
        const ReflectingSheet sheet = {&hull, frame.eyeFromSurface, frame.amplitude, frame.side};
        const auto start = std::chrono::steady_clock::now();
        const NdcExtent extent =
            ReflectedRays(sheet, frame.clipFromEye).extent(std::max(0.05, frame.slope));
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - start;
        REQUIRE(!extent.empty());
        microseconds.push_back(taken.count());
    }
    std::sort(microseconds.begin(), microseconds.end());
    WARN("median " << microseconds[1000] << " us, 99 % " << microseconds[1980] << " us");
}
