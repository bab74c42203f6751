#include "ReflectedExtent.h"

#include "../Transforms.h"
#include "../surface/ConvexHull.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <utility>

using namespace osgWaterReflect;

namespace
{

// Normals around the rim of the disc of slopes: with 24 three times as much lies idle.
const int RIM_NORMALS = 48;

using Polygon = std::vector<glm::dvec3>; // convex; clip x, y and w of its corners

// Clip x, y and w alone: what decides about places in the image.
glm::dvec3 imagePoint(const glm::dvec4& clip)
{
    return {clip.x, clip.y, clip.w};
}

// Outline [ndc] of what the view sees of the space that waves move a sheet in.
class SeenOutline
{
public:
    SeenOutline(const ReflectingSheet& sheet, const glm::dmat4& clipFromEye)
    {
        const glm::dmat4 clipFromSurface = clipFromEye * sheet.eyeFromSurface;
        const glm::dvec3 rise = imagePoint(sheet.amplitude * clipFromSurface[2]);
        const std::size_t size = sheet.hull->size();
        Polygon still;
        still.reserve(size);
        // Each side of the view adds a corner at most.
        _polygon.reserve(size + 4);
        _clipped.reserve(size + 4);
        _places.reserve(sheet.amplitude > 0.0 ? 2 * (size + 4) + 8 * size : size + 4);
        for (const glm::dvec2& corner : *sheet.hull)
            still.push_back(imagePoint(clipFromSurface * glm::dvec4(corner, 0.0, 1.0)));
        addMoved(still, rise);
        if (sheet.amplitude == 0.0) return;
        addMoved(still, -rise);
        for (std::size_t i = 0, last = still.size() - 1; i < still.size(); last = i++)
        {
            _polygon.assign(
                {still[last] + rise, still[i] + rise, still[i] - rise, still[last] - rise});
            addSeen();
        }
    }

    std::vector<glm::dvec2> hull() { return convexHull(std::move(_places)); }

private:
    void addMoved(const Polygon& still, const glm::dvec3& by)
    {
        _polygon = still;
        for (glm::dvec3& corner : _polygon)
            corner += by;
        addSeen();
    }

    void addSeen()
    {
        for (const glm::dvec3& side :
             {glm::dvec3(1, 0, 1), glm::dvec3(-1, 0, 1), glm::dvec3(0, 1, 1), glm::dvec3(0, -1, 1)})
            clip(side);
        for (const glm::dvec3& corner : _polygon)
            if (corner.z > 0.0) // not the eye itself
                _places.push_back(glm::clamp(glm::dvec2(corner) / corner.z, -1.0, 1.0));
    }

    // To where dot(plane, corner) >= 0.
    void clip(const glm::dvec3& plane)
    {
        _clipped.clear();
        for (std::size_t i = 0; i < _polygon.size(); ++i)
        {
            const glm::dvec3& a = _polygon[i];
            const glm::dvec3& b = _polygon[(i + 1) % _polygon.size()];
            const double atA = glm::dot(plane, a);
            const double atB = glm::dot(plane, b);
            if (atA >= 0.0) _clipped.push_back(a);
            if (atA * atB < 0.0) _clipped.push_back(glm::mix(a, b, atA / (atA - atB)));
        }
        _polygon.swap(_clipped);
    }

    std::vector<glm::dvec2> _places;
    Polygon _polygon; // that is being added
    Polygon _clipped;
};

// Takes directions to their images, without what is but rounding: an orthographic one lies at
// infinity, to whichever side.
class DirectionImage
{
public:
    explicit DirectionImage(const glm::dmat4& clipFromEye)
    {
        const glm::dmat4 rows = glm::transpose(clipFromEye);
        for (int i = 0; i < 3; ++i)
        {
            _rows[i] = glm::dvec3(rows[i < 2 ? i : 3]);
            _rounding[i] = 1e-12 * glm::length(_rows[i]);
        }
    }

    ///   length  of the direction
    glm::dvec3 of(const glm::dvec3& direction, double length) const
    {
        glm::dvec3 image;
        for (int i = 0; i < 3; ++i)
        {
            const double clip = glm::dot(_rows[i], direction);
            image[i] = std::abs(clip) > _rounding[i] * length ? clip : 0.0;
        }
        return image;
    }

private:
    glm::dvec3 _rows[3]; // of clip x, y and w
    double _rounding[3]; // of their products with a direction of length 1
};

} // namespace

ReflectedRays::ReflectedRays(const ReflectingSheet& sheet, const glm::dmat4& clipFromEye) :
    _clipFromEye(clipFromEye),
    _normalEyeFromSurface(sheet.side * normalMatrix(sheet.eyeFromSurface))
{
    const glm::dvec4 eyePoint = eyePointOf(clipFromEye);
    const glm::dmat3 eyeFromImage = glm::inverse(glm::dmat3(
        imagePoint(clipFromEye[0]), imagePoint(clipFromEye[1]), imagePoint(clipFromEye[2])));
    const std::vector<glm::dvec2> places = SeenOutline(sheet, clipFromEye).hull();
    _lines.reserve(places.size());
    for (const glm::dvec2& place : places)
    {
        const glm::dvec3 direction =
            eyePoint.w == 0.0 ? -glm::dvec3(eyePoint) : eyeFromImage * glm::dvec3(place, 1.0);
        _lines.push_back({direction, glm::length(direction)});
        _beginnings.add(glm::dvec3(place, 1.0));
    }
}

// For one normal, reflection and image are linear in the homogeneous sight line, so that the
// extremes come from the corners of the seen outline. For one sight line the ray turns with the
// normal without ever turning back, so that they come from the rim of the disc of slopes. What
// shade.glsl bends besides goes no farther: a normal that does not face the eye, or a ray sent
// below the horizon, ends between the sight line, the horizon and the calm ray.
NdcExtent ReflectedRays::extent(double maxSlope) const
{
    const double step = glm::two_pi<double>() / RIM_NORMALS;
    // The polygon around the disc, and as much again for what bends: of 2,000 frames swept, rays
    // left the extent of the polygon alone in some, by up to 4e-4 of it, and that of this one in
    // none.
    const double slope = maxSlope / std::pow(std::cos(0.5 * step), 2.0);
    const int numNormals = maxSlope > 0.0 ? RIM_NORMALS : 1; // just the still one in calm water
    const DirectionImage image(_clipFromEye);
    NdcExtent extent;
    for (int i = 0; i < numNormals; ++i)
    {
        const glm::dvec3 normal =
            glm::normalize(_normalEyeFromSurface *
                           glm::dvec3(slope * std::cos(i * step), slope * std::sin(i * step), 1.0));
        ImageHull hull = _beginnings;
        for (const SightLine& line : _lines)
            if (glm::dot(line.direction, normal) < 0.0)
                hull.add(image.of(glm::reflect(line.direction, normal), line.length));
        extent = unite(extent, hull.extent());
    }
    return extent;
}
