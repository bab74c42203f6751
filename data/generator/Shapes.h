#pragma once

#include "Mesh.h"

#include <osg/Vec2>

#include <functional>

namespace waterdata
{

void addBox(Mesh& mesh, const osg::Vec3& low, const osg::Vec3& high, const Colour& paint);

// A board whose one face has the corners a, b, c, d, and whose other face is off by `depth`.
void addSlab(Mesh& mesh, const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c,
             const osg::Vec3& d, const osg::Vec3& depth, const Colour& paint);

void addTube(Mesh& mesh, const osg::Vec3& from, const osg::Vec3& to, float radiusFrom,
             float radiusTo, int sides, const Colour& paint);

// Turns a profile of (radius, height) points, listed upwards, around the z axis.
using SurfacePaint = std::function<Colour(int row, int side)>;
void addTurned(Mesh& mesh, const std::vector<osg::Vec2>& profile, int sides,
               const SurfacePaint& paint);

void addBall(Mesh& mesh, const osg::Vec3& centre, const osg::Vec3& radii, int sides,
             const Colour& paint);

void addRing(Mesh& mesh, float radius, float thickness, int sides, const Colour& paint);

// A sphere of triangles (20 * 4^level) whose points are moved by `form`, from the unit sphere.
using Form = std::function<osg::Vec3(const osg::Vec3& onUnitSphere)>;
void addFormedBall(Mesh& mesh, int level, const Form& form, const Colour& paint);

}
