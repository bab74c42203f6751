#include "Mesh.h"

#include <algorithm>
#include <cmath>

using namespace osgwaterbench;

namespace
{

// Three visible faces of a box get three different shades; sides turned away get the ambient one.
const osg::Vec3d LIGHT_DIR(-0.35, -0.75, 0.561); // towards the light
const double AMBIENT = 0.4;                      // [1] of the colour

const GLubyte DARK_SQUARE = 160; // [of 255] clearly told from a bright one, whatever the colour

osg::Vec3 shaded(const osg::Vec3& colour, const osg::Vec3d& normal)
{
    const double light = std::max(normal * LIGHT_DIR, 0.0);
    return colour * static_cast<float>(AMBIENT + (1.0 - AMBIENT) * light);
}

GLubyte toByte(float share)
{
    return static_cast<GLubyte>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
}

} // namespace

Mesh::Mesh() :
    _places(new osg::Vec3Array), _colours(new osg::Vec4ubArray), _metres(new osg::Vec2Array),
    _triangles(new osg::DrawElementsUInt(GL_TRIANGLES))
{
}

unsigned int Mesh::addVertex(const osg::Vec3d& place, const osg::Vec3& colour,
                             const osg::Vec2d& metres)
{
    _places->push_back(place);
    _colours->push_back(
        osg::Vec4ub(toByte(colour.x()), toByte(colour.y()), toByte(colour.z()), 255));
    _metres->push_back(metres);
    return _places->size() - 1;
}

void Mesh::addTriangle(const std::array<Corner, 3>& corners, unsigned int parts)
{
    unsigned int below = 0; // first vertex of the row below
    for (unsigned int row = 0; row <= parts; ++row)
    {
        const unsigned int first = _places->size();
        const unsigned int columns = parts - row;
        for (unsigned int column = 0; column <= columns; ++column)
        {
            const double b = static_cast<double>(column) / parts;
            const double c = static_cast<double>(row) / parts;
            const double a = static_cast<double>(columns - column) / parts;
            addVertex(corners[0].place * a + corners[1].place * b + corners[2].place * c,
                      corners[0].colour * a + corners[1].colour * b + corners[2].colour * c);
            if (row == 0) continue;
            const unsigned int under = below + column;
            for (unsigned int index : {under, under + 1, first + column})
                _triangles->push_back(index);
            if (column == columns) continue;
            for (unsigned int index : {under + 1, first + column + 1, first + column})
                _triangles->push_back(index);
        }
        below = first;
    }
}

void Mesh::addRectangle(const osg::Vec3d& corner, const osg::Vec3d& wideVec,
                        const osg::Vec3d& highVec, const osg::Vec3& colour, unsigned int columns,
                        unsigned int rows)
{
    const osg::Vec3d wideDir = wideVec / wideVec.length();
    const osg::Vec3d highDir = highVec / highVec.length();
    const unsigned int first = _places->size();
    for (unsigned int row = 0; row <= rows; ++row)
        for (unsigned int column = 0; column <= columns; ++column)
        {
            const osg::Vec3d place = corner + wideVec * (static_cast<double>(column) / columns) +
                                     highVec * (static_cast<double>(row) / rows);
            addVertex(place, colour, osg::Vec2d(place * wideDir, place * highDir));
        }
    for (unsigned int row = 0; row < rows; ++row)
        for (unsigned int column = 0; column < columns; ++column)
        {
            const unsigned int at = first + row * (columns + 1) + column;
            const unsigned int above = at + columns + 1;
            for (unsigned int index : {at, at + 1, above + 1, at, above + 1, above})
                _triangles->push_back(index);
        }
}

void Mesh::addBox(const osg::Vec3d& lowest, const osg::Vec3d& highest, const osg::Vec3& colour,
                  unsigned int columns, unsigned int rows)
{
    const osg::Vec3d x(highest.x() - lowest.x(), 0, 0);
    const osg::Vec3d y(0, highest.y() - lowest.y(), 0);
    const osg::Vec3d z(0, 0, highest.z() - lowest.z());
    const auto addFace = [&](const osg::Vec3d& corner, const osg::Vec3d& wideVec,
                             const osg::Vec3d& highVec, unsigned int faceRows)
    {
        osg::Vec3d normal = wideVec ^ highVec;
        normal.normalize();
        addRectangle(corner, wideVec, highVec, shaded(colour, normal), columns, faceRows);
    };
    addFace(lowest, x, z, rows);
    addFace(lowest + x, y, z, rows);
    addFace(lowest + x + y, -x, z, rows);
    addFace(lowest + y, -y, z, rows);
    addFace(lowest + z, x, y, columns);
    addFace(lowest + y, x, -y, columns);
}

osg::ref_ptr<osg::Geometry> Mesh::takeGeometry()
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(_places);
    _colours->setNormalize(true);
    geometry->setColorArray(_colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, _metres);
    geometry->addPrimitiveSet(_triangles);
    *this = Mesh();
    return geometry;
}

osg::ref_ptr<osg::Texture2D> osgwaterbench::createChequers()
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    image->setInternalTextureFormat(GL_RGB8);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x)
            std::fill_n(image->data(x, y), 3, x == y ? 255 : DARK_SQUARE);

    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    return texture;
}
