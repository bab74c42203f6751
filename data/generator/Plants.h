#pragma once

#include "LakeLand.h"
#include "Random.h"

namespace waterdata
{

void addConifer(Mesh& mesh, Random& random, float height, int layers);
void addBroadleaf(Mesh& mesh, Random& random, float height, int level);
void addBush(Mesh& mesh, Random& random, float height);
void addReeds(Mesh& mesh, Random& random, const osg::Vec3& foot, float height);
void addRock(Mesh& mesh, Random& random, const osg::Vec3& radii);

// The wood on the hills, single trees near the shore, reeds and rocks along it.
std::vector<Mesh> lakeVegetation(const LakeLand& land);

}
