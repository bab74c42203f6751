#pragma once

#include "Daylight.h"

#include <osg/Geometry>

#include <vector>

namespace waterdata
{

// What the baker needs beside the geometry itself, whose colours are its paint before, and its lit
// colours after the baking.
struct BakeItem
{
    osg::ref_ptr<osg::Geometry> geometry;
    bool leafy = false;
};

// Lights the vertices by sun and sky, each item shading itself and all the others.
void bakeLight(const std::vector<BakeItem>& items, const Daylight& daylight);

}
