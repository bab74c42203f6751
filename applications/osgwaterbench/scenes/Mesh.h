#ifndef OSGWATERBENCH_MESH_H
#define OSGWATERBENCH_MESH_H

#include <osg/Geometry>
#include <osg/Texture2D>
#include <osg/Vec3d>

#include <array>

namespace osgwaterbench
{

/// Triangles with baked colours, gathered into one Geometry with vertex buffers.
/// Whatever a face is divided into, the surface and its colours stay the same.
class Mesh
{
public:
    Mesh();

    struct Corner
    {
        osg::Vec3d place;
        osg::Vec3 colour;
    };

    /// A triangle, each of its edges in `parts`: parts^2 triangles. It is counter clockwise from
    /// its front.
    void addTriangle(const std::array<Corner, 3>& corners, unsigned int parts = 1);

    /// A rectangle of one colour: 2 * columns * rows triangles. Its front is the side of
    /// wideVec ^ highVec. Texture coordinates are metres along its sides, from the origin of space.
    void addRectangle(const osg::Vec3d& corner, const osg::Vec3d& wideVec,
                      const osg::Vec3d& highVec, const osg::Vec3& colour, unsigned int columns = 1,
                      unsigned int rows = 1);

    /// A box in a colour that a fixed light shades, with a bottom. Its sides are divided into
    /// columns and rows, its top and bottom into columns both ways:
    /// columns * (8 * rows + 4 * columns) triangles.
    void addBox(const osg::Vec3d& lowest, const osg::Vec3d& highest, const osg::Vec3& colour,
                unsigned int columns = 1, unsigned int rows = 1);

    osg::ref_ptr<osg::Geometry> takeGeometry();

private:
    unsigned int addVertex(const osg::Vec3d& place, const osg::Vec3& colour,
                           const osg::Vec2d& metres = osg::Vec2d());

    osg::ref_ptr<osg::Vec3Array> _places;
    osg::ref_ptr<osg::Vec4ubArray> _colours;
    osg::ref_ptr<osg::Vec2Array> _metres;
    osg::ref_ptr<osg::DrawElementsUInt> _triangles;
};

/// Squares of 0.5 m for texture coordinates in metres. Nearest texels of the one level, so that
/// what is drawn is what a ray meets.
osg::ref_ptr<osg::Texture2D> createChequers();

} // namespace osgwaterbench

#endif
