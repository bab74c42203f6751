#ifndef OSGWATERREFLECT_REFERENCE_SCENETRIANGLES_H
#define OSGWATERREFLECT_REFERENCE_SCENETRIANGLES_H

#include <osg/Node>
#include <osg/Texture2D>
#include <osg/Vec2>
#include <osg/Vec3d>
#include <osg/Vec4>

#include <array>
#include <cstddef>
#include <vector>

namespace osgWaterReflect::reference
{

/// How the triangles of one drawable look.
struct SceneSurface
{
    bool writesDepth = true;
    osg::ref_ptr<const osg::Texture2D> texture; ///< of unit 0; null for none

    /// Colour of the texture at a place of it, (0, 0) at the first texel's outer corner.
    osg::Vec4 texel(const osg::Vec2d& uv) const;
};

struct SceneTriangle
{
    std::array<osg::Vec3d, 3> cornersWorld;
    std::array<osg::Vec4, 3> colours;
    std::array<osg::Vec2, 3> uvs;
    std::size_t surface = 0; ///< index into SceneTriangles::surfaces
};

/// The triangles of a scene in world coordinates, in double precision.
struct SceneTriangles
{
    std::vector<SceneTriangle> triangles;
    std::vector<SceneSurface> surfaces;

    /// Collects all of a scene that has an area and is finite; SceneTracer says what belongs to it.
    static SceneTriangles collect(osg::Node& scene);
};

} // namespace osgWaterReflect::reference

#endif
