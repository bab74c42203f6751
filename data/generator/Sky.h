#pragma once

#include <osg/Geode>

#include <string>

namespace waterdata
{

// A box that is drawn behind everything with the pictures sky/*.jpg of the data directory. It takes
// only the eye's turning, not its place, and writes no depth. The eye may move within `reach` of
// the origin: OSG drops what lies behind the eye altogether, even where culling is off. As long as
// the scene is wider than that, the box does not move the near and far planes.
osg::ref_ptr<osg::Geode> skyBox(const std::string& dataDirectory, float reach);

}
