#ifndef OSGWATERREFLECT_REFERENCE_PLANEQ_H
#define OSGWATERREFLECT_REFERENCE_PLANEQ_H

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgWaterReflect::reference
{

/// The plane Q of Li and Luo, built literally: two neighbouring pixels of an image column are
/// thrown back into space by the depths seen there, and span a plane with the eye. A reflected ray
/// meets the column's pixels where it meets that plane.
///
/// Double precision, and nothing shared with the shaders, whose closed form it stands to check.
struct PlaneQ
{
    glm::dvec3 normalEye; ///< of any length
    glm::dvec3 pointEye;  ///< on the plane

    /// Where a ray meets the plane, as t along it; infinite or NaN where it never does.
    double intersect(const glm::dvec3& originEye, const glm::dvec3& dirEye) const;
};

/// Which lines of the image a search goes along from one to the next.
enum class ImageLines
{
    COLUMNS = 0,
    ROWS = 1
};

/// An image and the matrix it was taken with.
struct ImageGeometry
{
    glm::dmat4 clipFromEye{1.0};
    glm::dvec2 size{0.0}; ///< [pixels]

    /// Window space: pixels and windowZ.
    glm::dvec3 windowFromEye(const glm::dvec3& pointEye) const;
    glm::dvec3 eyeFromWindow(const glm::dvec3& window) const;
};

/// Where the ray's image line crosses an image column (row), the other coordinate [pixels].
///   line  [pixels] x of the column's pixel centres (y of the row's)
double crossingOnLine(const ImageGeometry& image, const glm::dvec3& originEye,
                      const glm::dvec3& dirEye, ImageLines lines, double line);

/// Q through the two neighbouring pixels of a column (row) between whose centres a crossing lies.
///   windowZ  seen at the two pixels; any two values in [0, 1) give the same plane
PlaneQ planeOnLine(const ImageGeometry& image, ImageLines lines, double line, double crossing,
                   const glm::dvec2& windowZ);

} // namespace osgWaterReflect::reference

#endif
