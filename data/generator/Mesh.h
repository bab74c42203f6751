#pragma once

#include <osg/Matrixd>
#include <osg/Vec3>

#include <string>
#include <vector>

namespace waterdata
{

using Colour = osg::Vec3;

// 0xRRGGBB, as painters' tables give it.
Colour colour(unsigned int hex);
Colour shade(const Colour& base, float factor);

struct Triangle
{
    osg::Vec3 corners[3];
    Colour colours[3];
};

// A named set of coloured triangles, still without light. Shapes are added in the space of `frame`.
class Mesh
{
public:
    explicit Mesh(const std::string& meshName) : name(meshName) {}

    std::string name;
    osg::Matrixd frame;

    // Edges that meet at less than this angle (degrees) are shaded smoothly.
    float creaseAngle = 35.0f;

    // Longer edges are split before light is baked; 0 keeps the triangles as they are.
    float longestEdge = 0.6f;

    // Thin leaves: lit from both sides, and not by their own facing alone.
    bool leafy = false;

    std::vector<Triangle> triangles;

    void triangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const Colour& paint);
    void triangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c,
                  const Colour& paintA, const Colour& paintB, const Colour& paintC);
    void quad(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec3& d,
              const Colour& paint);
};

// Moves the mesh's frame for as long as the object lives.
class Placed
{
public:
    Placed(Mesh& mesh, const osg::Vec3& position, float turnDegrees = 0.0f);
    Placed(Mesh& mesh, const osg::Matrixd& local);
    ~Placed() { _mesh.frame = _outer; }
    Placed(const Placed&) = delete;
    Placed& operator=(const Placed&) = delete;

private:
    Mesh& _mesh;
    osg::Matrixd _outer;
};

}
