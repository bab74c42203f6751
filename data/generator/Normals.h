#pragma once

#include "Mesh.h"

namespace waterdata
{

// A normal for each corner of each triangle in turn, smooth over edges below the mesh's crease.
// (osgUtil::SmoothingVisitor smooths with a crease only where triangles already share vertices.)
std::vector<osg::Vec3> cornerNormals(const Mesh& mesh);

}
