#include "RayImage.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace battery;

namespace
{

using Depths = std::function<double(int x, int y)>; // windowZ, of any value

double uniform(std::mt19937_64& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

// windowZ as scenes have it: near 1 more often than not.
double someWindowZ(std::mt19937_64& random)
{
    return 1.0 - std::pow(uniform(random, 0.0, 1.0), 3.0);
}

Depths spheres(const glm::dvec2& size, std::mt19937_64& random)
{
    struct Sphere
    {
        glm::dvec2 centre;
        double radius;
        double windowZ;
        double bulge;
    };
    std::vector<Sphere> all(6);
    for (Sphere& sphere : all)
        sphere = {{uniform(random, 0.0, size.x), uniform(random, 0.0, size.y)},
                  uniform(random, 0.5, 0.3 * std::max(size.x, size.y) + 1.0),
                  someWindowZ(random),
                  uniform(random, 0.0, 0.1)};
    return [all](int x, int y)
    {
        double windowZ = 1.0;
        for (const Sphere& sphere : all)
        {
            const glm::dvec2 off = (glm::dvec2(x, y) + 0.5 - sphere.centre) / sphere.radius;
            const double inside = 1.0 - glm::dot(off, off);
            if (inside > 0.0)
                windowZ = std::min(windowZ, sphere.windowZ - sphere.bulge * std::sqrt(inside));
        }
        return windowZ;
    };
}

Depths depthsOf(Shown shown, const glm::dvec2& size, std::mt19937_64& random)
{
    const double first = someWindowZ(random);
    const double second = someWindowZ(random);
    const int band = 1 + static_cast<int>(uniform(random, 0.0, 40.0));
    switch (shown)
    {
    case Shown::PLANE:
    {
        const glm::dvec2 slope(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
        return [=](int x, int y) { return first + glm::dot(slope, glm::dvec2(x, y) / size); };
    }
    case Shown::SPHERES:
        return spheres(size, random);
    case Shown::STEPS:
        return [=](int x, int) { return x / band % 2 ? first : second; };
    case Shown::COMB:
        return [=](int x, int) { return x % 2 ? first : 1.0; };
    case Shown::CHECKERS:
        return [=](int x, int y) { return (x + y) % 2 ? first : second; };
    case Shown::NOISE:
        return [&random](int, int) { return someWindowZ(random); };
    case Shown::NEAR:
        return [](int, int) { return 0.0; };
    default:
        return [](int, int) { return 1.0; };
    }
}

glm::dmat4 projectionOf(Lens lens, RayImage& image)
{
    const double aspect = static_cast<double>(image.size.x) / image.size.y;
    double fovyDegrees = 46.0;
    if (lens == Lens::WIDE) fovyDegrees = 170.0;
    if (lens == Lens::NARROW) fovyDegrees = 0.1;
    if (lens == Lens::DEEP)
    {
        image.nearest = 1e-3;
        image.farthest = 1e6;
    }
    if (lens == Lens::ENDLESS)
    {
        image.farthest = 1e5;
        return glm::infinitePerspective(glm::radians(fovyDegrees), aspect, image.nearest);
    }
    if (lens == Lens::ORTHOGRAPHIC)
        return glm::ortho(-10.0 * aspect, 10.0 * aspect, -10.0, 10.0, image.nearest,
                          image.farthest);
    const double top = image.nearest * std::tan(glm::radians(0.5 * fovyDegrees));
    const double right = top * aspect;
    if (lens == Lens::OFF_AXIS)
        return glm::frustum(1.6 * right, -0.4 * right, -0.3 * top, 1.7 * top, image.nearest,
                            image.farthest);
    return glm::frustum(-right, right, -top, top, image.nearest, image.farthest);
}

float rounded(double windowZ, int bits)
{
    windowZ = glm::clamp(windowZ, 0.0, 1.0);
    if (bits == 32) return static_cast<float>(windowZ);
    const double steps = std::ldexp(1.0, bits) - 1.0;
    return static_cast<float>(std::round(windowZ * steps) / steps);
}

std::string nameOf(Shown shown)
{
    const char* const names[] = {"plane",    "spheres", "steps", "comb",
                                 "checkers", "noise",   "near",  "background"};
    return names[static_cast<int>(shown)];
}

std::string nameOf(Lens lens)
{
    const char* const names[] = {"perspective", "wide",     "narrow",      "deep",
                                 "endless",     "off-axis", "orthographic"};
    return names[static_cast<int>(lens)];
}

} // namespace

glm::mat4 RayImage::imageFromEye() const
{
    return glm::mat4(osgWaterReflect::imageFromClip() * clipFromEye);
}

glm::dvec3 RayImage::eyeFromWindow(const glm::dvec3& window) const
{
    const glm::dvec3 ndc = window / glm::dvec3(size, 1.0) * 2.0 - 1.0;
    const glm::dvec4 eye = glm::inverse(clipFromEye) * glm::dvec4(ndc, 1.0);
    return glm::dvec3(eye) / eye.w;
}

glm::dvec3 RayImage::windowFromEye(const glm::dvec3& eye) const
{
    const glm::dvec4 clip = clipFromEye * glm::dvec4(eye, 1.0);
    return (0.5 * glm::dvec3(clip) / clip.w + 0.5) * glm::dvec3(size, 1.0);
}

glm::dvec2 RayImage::depthScale() const
{
    if (isOrthographic()) return {0.0, 0.5 * std::abs(clipFromEye[2][2])};
    return {0.5 * std::abs(clipFromEye[3][2]), 0.0};
}

double RayImage::pixelExtent() const
{
    return 2.0 / (std::abs(clipFromEye[0][0]) * size.x);
}

RayImage battery::createImage(Shown shown, Lens lens, int bits, const glm::ivec2& size,
                              std::mt19937_64& random)
{
    RayImage image;
    image.name = nameOf(shown) + ", " + nameOf(lens) + ", " + std::to_string(bits) + " bits";
    image.size = size;
    image.mirrored = lens == Lens::OFF_AXIS;
    image.clipFromEye = projectionOf(lens, image);
    image.thickness = std::pow(10.0, uniform(random, -3.0, 1.0));

    const Depths depths = depthsOf(shown, glm::dvec2(size), random);
    image.windowZ.reserve(static_cast<std::size_t>(size.x) * size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            image.windowZ.push_back(rounded(depths(x, y), bits));
    return image;
}
