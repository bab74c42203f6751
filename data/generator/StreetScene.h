#pragma once

#include <osg/Group>

#include <string>

namespace waterdata
{

// A town street after rain; the sky's pictures are read from sky/ in `dataDirectory`.
osg::ref_ptr<osg::Group> streetScene(const std::string& dataDirectory);

}
