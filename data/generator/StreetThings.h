#pragma once

#include "Mesh.h"

namespace waterdata
{

// Each stands on z = 0 at the origin of the mesh's frame; car and bicycle look along +x.
void addCar(Mesh& mesh, const Colour& paint);
void addBicycle(Mesh& mesh, const Colour& paint);
void addLamp(Mesh& mesh);
void addBollard(Mesh& mesh);
void addBin(Mesh& mesh);

}
