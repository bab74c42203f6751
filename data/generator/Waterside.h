#pragma once

#include "Mesh.h"

namespace waterdata
{

// A pier of planks on posts along +x, its deck's upper side at z = 0.62.
void addPier(Mesh& mesh, float length, float width);

// A boathouse on posts, open towards -y.
void addBoathouse(Mesh& mesh);

void addLighthouse(Mesh& mesh);

}
