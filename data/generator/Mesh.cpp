#include "Mesh.h"

#include <osg/Math>

namespace waterdata
{

Colour colour(unsigned int hex)
{
    const auto channel = [hex](int shift) { return ((hex >> shift) & 0xffu) / 255.0f; };
    return Colour(channel(16), channel(8), channel(0));
}

Colour shade(const Colour& base, float factor)
{
    Colour result = base * factor;
    for (int channel = 0; channel < 3; ++channel)
        result[channel] = osg::clampBetween(result[channel], 0.0f, 1.0f);
    return result;
}

void Mesh::triangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const Colour& paint)
{
    triangle(a, b, c, paint, paint, paint);
}

void Mesh::triangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c,
                    const Colour& paintA, const Colour& paintB, const Colour& paintC)
{
    triangles.push_back({{a * frame, b * frame, c * frame}, {paintA, paintB, paintC}});
}

void Mesh::quad(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec3& d,
                const Colour& paint)
{
    triangle(a, b, c, paint);
    triangle(a, c, d, paint);
}

Placed::Placed(Mesh& mesh, const osg::Vec3& position, float turnDegrees)
    : Placed(mesh, osg::Matrixd::rotate(osg::DegreesToRadians(turnDegrees), osg::Z_AXIS)
                       * osg::Matrixd::translate(position))
{
}

Placed::Placed(Mesh& mesh, const osg::Matrixd& local) : _mesh(mesh), _outer(mesh.frame)
{
    _mesh.frame = local * _outer;
}

}
