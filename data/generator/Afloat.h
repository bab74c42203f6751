#pragma once

#include "Mesh.h"

namespace waterdata
{

// What floats has its waterline at z = 0 of the mesh's frame, and looks along +x.
void addDuck(Mesh& mesh);
void addBeachBall(Mesh& mesh);
void addRowingBoat(Mesh& mesh);

// A buoy, red above the water, with a top mark.
void addBuoy(Mesh& mesh);

}
