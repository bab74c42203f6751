#include "RayScene.h"

#include <osg/TriangleIndexFunctor>

#include <cstring>
#include <stdexcept>

namespace waterdata
{

RayScene::RayScene() : _device(rtcNewDevice(nullptr)), _scene(nullptr)
{
    if (!_device)
        throw std::runtime_error("Embree finds no device");
    _scene = rtcNewScene(_device);
}

RayScene::~RayScene()
{
    rtcReleaseScene(_scene);
    rtcReleaseDevice(_device);
}

void RayScene::add(const osg::Vec3Array& vertices, const std::vector<unsigned int>& corners)
{
    if (corners.empty())
        return;
    RTCGeometry shape = rtcNewGeometry(_device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* points = rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(osg::Vec3), vertices.size());
    std::memcpy(points, vertices.getDataPointer(), vertices.getTotalDataSize());
    void* indices = rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(unsigned int), corners.size() / 3);
    std::memcpy(indices, corners.data(), corners.size() * sizeof(unsigned int));
    rtcCommitGeometry(shape);
    rtcAttachGeometry(_scene, shape);
    rtcReleaseGeometry(shape);
}

void RayScene::build()
{
    rtcCommitScene(_scene);
}

bool RayScene::blocked(const osg::Vec3& from, const osg::Vec3& direction, float reach) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = {};
    ray.org_x = from.x();
    ray.org_y = from.y();
    ray.org_z = from.z();
    ray.dir_x = direction.x();
    ray.dir_y = direction.y();
    ray.dir_z = direction.z();
    ray.tfar = reach;
    ray.mask = 0xffffffffu;
    rtcOccluded1(_scene, &context, &ray);
    return ray.tfar < 0.0f;
}

namespace
{

struct CornerCollector
{
    std::vector<unsigned int> corners;

    void operator()(unsigned int a, unsigned int b, unsigned int c)
    {
        if (a == b || b == c || c == a)
            return;
        corners.push_back(a);
        corners.push_back(b);
        corners.push_back(c);
    }
};

}

std::vector<unsigned int> triangleCorners(const osg::Geometry& geometry)
{
    osg::TriangleIndexFunctor<CornerCollector> collector;
    geometry.accept(collector);
    return collector.corners;
}

}
