#include "ReflectedExtent.h"

#include "../Transforms.h"
#include "../surface/ConvexHull.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

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

// The part of a polygon where dot(plane, corner) >= 0.
Polygon clipped(const Polygon& polygon, const glm::dvec3& plane)
{
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double atA = glm::dot(plane, a);
        const double atB = glm::dot(plane, b);
        if (atA >= 0.0) inside.push_back(a);
        if (atA * atB < 0.0) inside.push_back(glm::mix(a, b, atA / (atA - atB)));
    }
    return inside;
}

void appendSeen(std::vector<glm::dvec2>& places, Polygon polygon)
{
    for (const glm::dvec3& side :
         {glm::dvec3(1, 0, 1), glm::dvec3(-1, 0, 1), glm::dvec3(0, 1, 1), glm::dvec3(0, -1, 1)})
        polygon = clipped(polygon, side);
    for (const glm::dvec3& corner : polygon)
        if (corner.z > 0.0) // not the eye itself
            places.push_back(glm::clamp(glm::dvec2(corner) / corner.z, -1.0, 1.0));
}

// Outline [ndc] of what the view sees of the space that waves move a sheet in.
std::vector<glm::dvec2> seenOutline(const ReflectingSheet& sheet, const glm::dmat4& clipFromEye)
{
    const glm::dmat4 clipFromSurface = clipFromEye * sheet.eyeFromSurface;
    const glm::dvec3 rise = imagePoint(sheet.amplitude * clipFromSurface[2]);
    Polygon crests, troughs;
    for (const glm::dvec2& corner : *sheet.hull)
    {
        const glm::dvec3 still = imagePoint(clipFromSurface * glm::dvec4(corner, 0.0, 1.0));
        crests.push_back(still + rise);
        troughs.push_back(still - rise);
    }

    std::vector<glm::dvec2> places;
    appendSeen(places, crests);
    if (sheet.amplitude > 0.0)
    {
        appendSeen(places, troughs);
        for (std::size_t i = 0, last = crests.size() - 1; i < crests.size(); last = i++)
            appendSeen(places, {crests[last], crests[i], troughs[i], troughs[last]});
    }
    return convexHull(places);
}

// Sight lines to places [ndc], in eye space, of any length.
std::vector<glm::dvec3> sightLines(const std::vector<glm::dvec2>& places,
                                   const glm::dmat4& clipFromEye)
{
    const glm::dvec4 eyePoint = eyePointOf(clipFromEye);
    if (eyePoint.w == 0.0) return std::vector<glm::dvec3>(places.size(), -glm::dvec3(eyePoint));

    const glm::dmat3 eyeFromImage = glm::inverse(glm::dmat3(
        imagePoint(clipFromEye[0]), imagePoint(clipFromEye[1]), imagePoint(clipFromEye[2])));
    std::vector<glm::dvec3> lines;
    for (const glm::dvec2& place : places)
        lines.push_back(eyeFromImage * glm::dvec3(place, 1.0));
    return lines;
}

// Unit normals in eye space around the rim of the disc of slopes; just the still one in calm water.
std::vector<glm::dvec3> rimNormals(const ReflectingSheet& sheet)
{
    const glm::dmat3 eyeFromSurface = sheet.side * normalMatrix(sheet.eyeFromSurface);
    if (!(sheet.maxSlope > 0.0)) return {glm::normalize(eyeFromSurface[2])};
    const double step = glm::two_pi<double>() / RIM_NORMALS;
    // The polygon around the disc, and as much again for what bends: of 2,000 frames swept, rays
    // left the extent of the polygon alone in some, by up to 4e-4 of it, and that of this one in
    // none.
    const double slope = sheet.maxSlope / std::pow(std::cos(0.5 * step), 2.0);
    std::vector<glm::dvec3> normals;
    for (int i = 0; i < RIM_NORMALS; ++i)
        normals.push_back(
            glm::normalize(eyeFromSurface * glm::dvec3(slope * std::cos(i * step),
                                                       slope * std::sin(i * step), 1.0)));
    return normals;
}

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

// For one normal, reflection and image are linear in the homogeneous sight line, so that the
// extremes come from the corners of the seen outline. For one sight line the ray turns with the
// normal without ever turning back, so that they come from the rim. What shade.glsl bends besides
// goes no farther: a normal that does not face the eye, or a ray sent below the horizon, ends
// between the sight line, the horizon and the calm ray.
NdcExtent osgWaterReflect::reflectedExtent(const ReflectingSheet& sheet,
                                           const glm::dmat4& clipFromEye)
{
    const std::vector<glm::dvec2> places = seenOutline(sheet, clipFromEye);
    const std::vector<glm::dvec3> lines = sightLines(places, clipFromEye);
    std::vector<double> lengths;
    ImageHull beginnings; // of rays
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        lengths.push_back(glm::length(lines[i]));
        beginnings.add(glm::dvec3(places[i], 1.0));
    }
    const DirectionImage image(clipFromEye);
    NdcExtent extent;
    for (const glm::dvec3& normal : rimNormals(sheet))
    {
        ImageHull hull = beginnings;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (glm::dot(lines[i], normal) < 0.0)
                hull.add(image.of(glm::reflect(lines[i], normal), lengths[i]));
        extent = unite(extent, hull.extent());
    }
    return extent;
}
