#pragma once

#include "Daylight.h"

#include <osg/Group>

#include <vector>

namespace waterdata
{

// Turns the painted meshes into a lit scene, one named Geode for each mesh. `focus` is where the
// pictures are taken from.
osg::ref_ptr<osg::Group> bakeScene(std::vector<Mesh> meshes, const Daylight& daylight,
                                   const osg::Vec3& focus);

}
