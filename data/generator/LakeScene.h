#pragma once

#include <osg/Group>

#include <string>

namespace waterdata
{

// The demo's lake; the sky's pictures are read from sky/ in `dataDirectory`.
osg::ref_ptr<osg::Group> lakeScene(const std::string& dataDirectory);

}
