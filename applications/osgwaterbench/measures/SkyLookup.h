#ifndef OSGWATERBENCH_SKYLOOKUP_H
#define OSGWATERBENCH_SKYLOOKUP_H

#include <osg/TextureCubeMap>

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace osgwaterbench
{

/// The sky's colour by direction, as OpenGL reads a cube map: face and place by the table of
/// [OpenGL46 8.13], four texels of the finest level mixed, and at a face's edge its own texels only
/// (LINEAR, CLAMP_TO_EDGE, not seamless). May be asked by many threads at once.
class SkyLookup
{
public:
    /// A sky of one colour.
    explicit SkyLookup(const glm::dvec3& colour);

    /// Copies the faces' texels. Six square images of one size, of a format that
    /// osg::Image::getColor() reads; a face without image is black.
    explicit SkyLookup(const osg::TextureCubeMap& cubeMap);

    ///   dirWorld  of any length but 0
    glm::dvec3 colour(const glm::dvec3& dirWorld) const;

private:
    struct Face
    {
        int side = 1;                                      // [texels]
        std::vector<glm::vec3> texels = {glm::vec3(0.0f)}; // row by row from t = 0
    };

    std::array<Face, 6> _faces; // in the order of osg::TextureCubeMap::Face
};

} // namespace osgwaterbench

#endif
