#ifndef OSGWATERVIEWER_SKY_H
#define OSGWATERVIEWER_SKY_H

#include <osg/TextureCubeMap>

#include <string>

namespace osgwaterviewer
{

/// The cube map of a directory's pictures posx, negx, posy, negy, posz and negz, of any format that
/// OSG reads, looked up with directions in the world; each picture's lowest row is t = 0 of
/// OpenGL's cube map face. Null, with a message, where one is missing or not of the others' size.
osg::ref_ptr<osg::TextureCubeMap> readSky(const std::string& directory);

} // namespace osgwaterviewer

#endif
