#pragma once

#include "Mesh.h"

namespace waterdata
{

// Splits the edges that are longer than the mesh asks for. The limit grows with the distance from
// `focus`, where the picture shows less. Neighbours split their common edge alike: no cracks.
void subdivide(Mesh& mesh, const osg::Vec3& focus);

}
