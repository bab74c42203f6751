#include "RaySet.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace battery;

namespace
{

// Makes rays for one image.
class RayMaker
{
public:
    RayMaker(const RayImage& image, std::mt19937_64& random) : _image(image), _random(random) {}

    Ray make(RaySet set)
    {
        switch (set)
        {
        case RaySet::WATER:
            return reflected(height(1.0), 0.1);
        case RaySet::ALONG_AXIS:
            return beside(alongAxis());
        case RaySet::ONE_PLACE:
            return beside(toOrFromEye());
        case RaySet::TOWARD_EYE:
            return beside(towardEye());
        case RaySet::ENDLESS:
            return beside(endless());
        case RaySet::GRAZING:
            return beside(reflected(grazingHeight(), 1e-3));
        case RaySet::THROUGH:
            return beside(through());
        case RaySet::CELL_EDGES:
            return beside(alongCells());
        case RaySet::BORDER:
            return beside(fromBorder());
        default:
            return {place(), direction()};
        }
    }

private:
    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(_random);
    }
    int integer(int low, int high)
    {
        return std::uniform_int_distribution<int>(low, high)(_random);
    }
    bool chance() { return integer(0, 1) == 1; }
    double tiny() { return std::pow(10.0, uniform(-38.0, -3.0)) * (chance() ? 1.0 : -1.0); }

    glm::dvec2 pixels() { return {uniform(0.0, _image.size.x), uniform(0.0, _image.size.y)}; }

    // Of all depths alike.
    double windowZ()
    {
        const double depth =
            _image.nearest * std::pow(_image.farthest / _image.nearest, uniform(0.0, 1.0));
        return glm::clamp(_image.windowFromEye(glm::dvec3(0.0, 0.0, -depth)).z, 0.0, 1.0);
    }

    glm::dvec3 window() { return glm::dvec3(pixels(), windowZ()); }
    glm::vec3 place() { return glm::vec3(_image.eyeFromWindow(window())); }

    glm::vec3 direction()
    {
        std::normal_distribution<double> normal;
        glm::dvec3 v;
        do
            v = {normal(_random), normal(_random), normal(_random)};
        while (glm::length(v) < 1e-3);
        return glm::vec3(glm::normalize(v));
    }

    Ray between(const glm::dvec3& firstWindow, const glm::dvec3& secondWindow)
    {
        const glm::dvec3 first = _image.eyeFromWindow(firstWindow);
        const glm::dvec3 second = _image.eyeFromWindow(secondWindow);
        const glm::dvec3 apart = second - first;
        if (!(glm::length(apart) > 0.0)) return {glm::vec3(first), direction()};
        return {glm::vec3(first), glm::vec3(glm::normalize(apart))};
    }

    // Every other ray is as it was made; of the rest each number is off by a power of two of steps.
    Ray beside(Ray ray)
    {
        if (chance()) return ray;
        for (glm::vec3* v : {&ray.originEye, &ray.dirEye})
            for (int axis = 0; axis < 3; ++axis)
            {
                const int steps = 1 << integer(0, 6);
                const float to = (chance() ? 1.0f : -1.0f) * std::numeric_limits<float>::max();
                for (int i = 0; i < steps && chance(); ++i)
                    (*v)[axis] = std::nextafter((*v)[axis], to);
            }
        return ray;
    }

    double height(double greatest) { return greatest * std::pow(10.0, uniform(-2.0, 0.0)); }
    double grazingHeight()
    {
        return integer(0, 3) == 0 ? 0.0 : std::pow(10.0, uniform(-7.0, -3.0));
    }

    // Off a level plane that lies lower than the eye by a height, with waves of a slope.
    Ray reflected(double eyeHeight, double slope)
    {
        const double depth =
            _image.nearest * std::pow(_image.farthest / _image.nearest, uniform(0.0, 1.0));
        const glm::dvec3 seen = _image.eyeFromWindow(glm::dvec3(pixels(), 0.5)); // gives the column
        const double across = _image.isOrthographic() ? seen.x : seen.x / seen.z * -depth;
        const glm::dvec3 point(across, -eyeHeight, -depth);
        const glm::dvec3 sight = _image.isOrthographic() ? glm::dvec3(0.0, 0.0, -1.0) : point;
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(uniform(-slope, slope), 1.0, uniform(-slope, slope)));
        return {glm::vec3(point), glm::vec3(glm::normalize(glm::reflect(sight, normal)))};
    }

    Ray alongAxis()
    {
        // The middle of the image stays the middle in every rounding.
        if (integer(0, 3) == 0)
        {
            const double depth = _image.nearest + uniform(0.1, 10.0);
            const glm::dvec3 origin(0.0, uniform(-0.3, 0.3) * depth, -depth);
            const glm::dvec3 dir =
                glm::normalize(glm::dvec3(0.0, uniform(-1.0, 1.0), uniform(-1.0, 1.0)));
            if (chance()) return {glm::vec3(origin), glm::vec3(dir)};
            return {glm::vec3(origin.y, 0.0, origin.z), glm::vec3(dir.y, 0.0, dir.z)};
        }
        const glm::dvec3 first = window();
        glm::dvec3 second = window();
        const int axis = integer(0, 1);
        second[axis] = first[axis];
        return between(first, second);
    }

    Ray toOrFromEye()
    {
        const glm::dvec3 origin = _image.eyeFromWindow(window());
        const glm::dvec3 sight =
            _image.isOrthographic() ? glm::dvec3(0.0, 0.0, -1.0) : glm::normalize(origin);
        return {glm::vec3(origin), glm::vec3((chance() ? 1.0 : -1.0) * sight)};
    }

    Ray towardEye()
    {
        const glm::dvec3 origin = _image.eyeFromWindow(window());
        const double z = _image.nearest * (chance() ? -1.0 : uniform(-2.0, 2.0));
        const glm::dvec3 goal(uniform(-1.0, 1.0) * _image.nearest,
                              uniform(-1.0, 1.0) * _image.nearest, z);
        const glm::dvec3 apart = goal - origin;
        if (!(glm::length(apart) > 0.0)) return {glm::vec3(origin), direction()};
        return {glm::vec3(origin), glm::vec3(glm::normalize(apart))};
    }

    Ray endless()
    {
        glm::vec3 dir = direction();
        dir.z = 0.0f;
        if (integer(0, 3) == 0) dir[integer(0, 1)] = 0.0f;
        if (!(glm::length(dir) > 0.0f)) dir.x = 1.0f;
        dir = glm::normalize(dir);
        if (chance()) dir.z = static_cast<float>(tiny());
        return {place(), dir};
    }

    Ray through()
    {
        glm::dvec3 first(pixels(), uniform(0.0, 1.0) * 1e-4);
        glm::dvec3 second(pixels(), 1.0 - uniform(0.0, 1.0) * 1e-4);
        if (chance()) std::swap(first, second);
        return between(first, second);
    }

    Ray alongCells()
    {
        const int sides[] = {1, 4, 32, 256};
        const int side = sides[integer(0, 3)];
        const auto onEdge = [&](int axis)
        { return static_cast<double>(side * integer(0, _image.size[axis] / side)); };
        glm::dvec3 first = window();
        glm::dvec3 second = window();
        switch (integer(0, 2))
        {
        case 0: // along one
        {
            const int axis = integer(0, 1);
            first[axis] = second[axis] = onEdge(axis);
            break;
        }
        case 1: // through two corners
            for (int axis : {0, 1})
            {
                first[axis] = onEdge(axis);
                second[axis] = onEdge(axis);
            }
            break;
        default: // through every corner on its way
        {
            first.x = onEdge(0);
            first.y = onEdge(1);
            const double length = uniform(1.0, std::max(_image.size.x, _image.size.y) + 1.0);
            second.x = first.x + (chance() ? length : -length);
            second.y = first.y + (chance() ? length : -length);
        }
        }
        return between(first, second);
    }

    Ray fromBorder()
    {
        const auto onBorder = [&]
        {
            glm::dvec3 place = window();
            const int axis = integer(0, 1);
            const double inset = integer(0, 2) * 0.5;
            place[axis] = chance() ? inset : _image.size[axis] - inset;
            return place;
        };
        return between(onBorder(), onBorder());
    }

    const RayImage& _image;
    std::mt19937_64& _random;
};

} // namespace

std::string battery::nameOf(RaySet set)
{
    const char* const names[] = {"anywhere",       "water",   "along axes", "one place",
                                 "toward the eye", "endless", "grazing",    "through",
                                 "cell edges",     "border"};
    return names[static_cast<int>(set)];
}

std::vector<Ray> battery::createRays(RaySet set, const RayImage& image, int count,
                                     std::mt19937_64& random)
{
    RayMaker maker(image, random);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i)
        rays.push_back(maker.make(set));
    return rays;
}
