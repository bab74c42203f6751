#pragma once

#include <osg/Geometry>

#include <embree3/rtcore.h>

namespace waterdata
{

// The triangles of many geometries, for asking whether a way is free.
class RayScene
{
public:
    RayScene();
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    void add(const osg::Vec3Array& vertices, const std::vector<unsigned int>& corners);
    void build();
    bool blocked(const osg::Vec3& from, const osg::Vec3& direction, float reach) const;

private:
    RTCDevice _device;
    RTCScene _scene;
};

// The corner indices of all triangles of a geometry.
std::vector<unsigned int> triangleCorners(const osg::Geometry& geometry);

}
