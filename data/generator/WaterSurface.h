#pragma once

#include <osg/Geode>

#include <vector>

namespace waterdata
{

// The Geode named "water": the flat polygon (counter-clockwise seen from above, maybe concave).
osg::ref_ptr<osg::Geode> waterSurface(const std::vector<osg::Vec3>& outline);

}
