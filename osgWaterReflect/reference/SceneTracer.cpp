#include "SceneTracer.h"

#include "SceneTriangles.h"

#include <osg/Notify>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect::reference;

namespace
{

// Shares of a triangle's corners in a place on it; they sum to 1.
using Shares = std::array<double, 3>;

Shares sharesOf(double second, double third)
{
    return {1.0 - second - third, second, third};
}

template <class Value, class Element>
Value mixed(const std::array<Element, 3>& corners, const Shares& shares)
{
    return Value(corners[0]) * shares[0] + Value(corners[1]) * shares[1] +
           Value(corners[2]) * shares[2];
}

struct Ray
{
    osg::Vec3d origin;
    osg::Vec3d dir; // of unit length
};

osg::Vec3d areaVector(const SceneTriangle& triangle)
{
    const std::array<osg::Vec3d, 3>& c = triangle.cornersWorld;
    return (c[1] - c[0]) ^ (c[2] - c[0]);
}

// The place in double precision on a triangle that single precision says is hit, at its shares u
// and v of the second and third corner.
//   slack  [world units] how far single precision may have gone astray
Shares refine(const SceneTriangle& triangle, const Ray& ray, double u, double v, double slack)
{
    const std::array<osg::Vec3d, 3>& c = triangle.cornersWorld;
    const osg::Vec3d edge1 = c[1] - c[0];
    const osg::Vec3d edge2 = c[2] - c[0];
    const osg::Vec3d p = ray.dir ^ edge2;
    const osg::Vec3d q = (ray.origin - c[0]) ^ edge1;
    const double determinant = edge1 * p;
    const Shares onPlane =
        sharesOf(((ray.origin - c[0]) * p) / determinant, (ray.dir * q) / determinant);
    // Past an edge the place is drawn back onto the triangle.
    const double second = std::max(onPlane[1], 0.0);
    const double third = std::max(onPlane[2], 0.0);
    const double sum = std::max(second + third, 1.0);
    const Shares drawnBack = sharesOf(second / sum, third / sum);
    const double drawn = (mixed<osg::Vec3d>(c, onPlane) - mixed<osg::Vec3d>(c, drawnBack)).length();
    // Edge-on the plane does not tell the place: what single precision says stays.
    return drawn <= slack ? drawnBack : sharesOf(u, v);
}

// A unit vector perpendicular to another.
osg::Vec3d anyNormal(const osg::Vec3d& dir)
{
    osg::Vec3d normal = dir ^ (std::abs(dir.x()) < 0.6 ? osg::Vec3d(1, 0, 0) : osg::Vec3d(0, 1, 0));
    normal.normalize();
    return normal;
}

bool isFinite(const osg::Vec3d& v)
{
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

// What Embree's filter is told of the ray; the context comes first, so that it can be cast back.
struct Query
{
    RTCIntersectContext context;
    const std::vector<SceneTriangle>* triangles = nullptr;
    Ray ray;
    double nearest = 0.0;
    double slack = 0.0; // as refine() takes it
};

struct Meeting
{
    const SceneTriangle* triangle = nullptr;
    Shares shares;
    osg::Vec3d point;
    double t = 0.0;
};

Meeting meetingAt(const Query& query, const RTCHit& hit)
{
    Meeting meeting;
    meeting.triangle = &(*query.triangles)[hit.primID];
    meeting.shares = refine(*meeting.triangle, query.ray, hit.u, hit.v, query.slack);
    meeting.point = mixed<osg::Vec3d>(meeting.triangle->cornersWorld, meeting.shares);
    meeting.t = (meeting.point - query.ray.origin) * query.ray.dir;
    return meeting;
}

// Passes triangles that in double precision lie before the nearest place that counts.
void passBeforeNearest(const RTCFilterFunctionNArguments* arguments)
{
    const auto& query = *reinterpret_cast<const Query*>(arguments->context);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    if (meetingAt(query, hit).t < query.nearest) arguments->valid[0] = 0;
}

// What single precision finds along the ray from a place of the Embree scene's own.
std::optional<Meeting> meet(RTCScene scene, Query& query, const osg::Vec3d& from)
{
    RTCRayHit rayHit = {};
    rayHit.ray.org_x = static_cast<float>(from.x());
    rayHit.ray.org_y = static_cast<float>(from.y());
    rayHit.ray.org_z = static_cast<float>(from.z());
    rayHit.ray.dir_x = static_cast<float>(query.ray.dir.x());
    rayHit.ray.dir_y = static_cast<float>(query.ray.dir.y());
    rayHit.ray.dir_z = static_cast<float>(query.ray.dir.z());
    rayHit.ray.tfar = std::numeric_limits<float>::infinity();
    rayHit.ray.mask = ~0u;
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &query.context, &rayHit);
    if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return meetingAt(query, rayHit.hit);
}

} // namespace

struct SceneTracer::Scene
{
    ~Scene()
    {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void build();

    SceneTriangles all;
    osg::Vec3d centre;
    double radius = 0.0; // of a sphere about the centre that holds every corner
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
};

void SceneTracer::Scene::build()
{
    const std::vector<SceneTriangle>& triangles = all.triangles;
    if (triangles.empty()) return;
    osg::Vec3d least = triangles[0].cornersWorld[0];
    osg::Vec3d most = least;
    for (const SceneTriangle& triangle : triangles)
        for (const osg::Vec3d& corner : triangle.cornersWorld)
            for (int i = 0; i < 3; ++i)
            {
                least[i] = std::min(least[i], corner[i]);
                most[i] = std::max(most[i], corner[i]);
            }
    centre = (least + most) * 0.5;
    radius = 0.5 * (most - least).length();

    device = rtcNewDevice(nullptr);
    if (!device)
    {
        OSG_WARN
            << "SceneTracer::SceneTracer: expected a device of Embree, got none; nothing is hit"
            << std::endl;
        return;
    }
    // Corners that coincide in double precision do so in single precision: no gaps open.
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned int*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned int), triangles.size()));
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i)
    {
        const osg::Vec3d corner = triangles[i / 3].cornersWorld[i % 3] - centre;
        for (int axis = 0; axis < 3; ++axis)
            corners[3 * i + axis] = static_cast<float>(corner[axis]);
        indices[i] = static_cast<unsigned int>(i);
    }
    rtcCommitGeometry(geometry);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                       RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
}

SceneTracer::SceneTracer(osg::Node& scene, Kept kept) : _scene(new Scene)
{
    _scene->all = SceneTriangles::collect(scene);
    if (kept == Kept::DEPTH_WRITERS)
    {
        std::vector<SceneTriangle>& triangles = _scene->all.triangles;
        const auto isLeftOut = [this](const SceneTriangle& triangle)
        { return !_scene->all.surfaces[triangle.surface].writesDepth; };
        triangles.erase(std::remove_if(triangles.begin(), triangles.end(), isLeftOut),
                        triangles.end());
    }
    _scene->build();
}

SceneTracer::~SceneTracer() = default;

std::size_t SceneTracer::triangleCount() const
{
    return _scene->all.triangles.size();
}

std::optional<SceneHit> SceneTracer::trace(const osg::Vec3d& originWorld,
                                           const osg::Vec3d& dirWorld, double nearest) const
{
    const double length = dirWorld.length();
    if (!_scene->scene || !isFinite(originWorld) || !(length > 0.0) || !std::isfinite(length) ||
        !std::isfinite(nearest))
        return std::nullopt;

    Query query;
    rtcInitIntersectContext(&query.context);
    query.context.filter = passBeforeNearest;
    query.triangles = &_scene->all.triangles;
    query.ray = {originWorld, dirWorld / length};
    query.nearest = nearest;

    // From where the ray comes to the scene's sphere, or a little before the nearest place that
    // counts: so all that is rounded to single precision is about as large as the scene.
    query.slack = 1e-5 * _scene->radius; // a hundred roundings
    const double middle = (_scene->centre - originWorld) * query.ray.dir;
    const double start = std::max(nearest - query.slack, middle - 2.0 * _scene->radius);
    const osg::Vec3d from = originWorld + query.ray.dir * start - _scene->centre;
    if (from.length() > 4.0 * _scene->radius) return std::nullopt; // it passes by, or leads away

    // Embree lets no ray slip through an edge, but of those that are aimed right at a corner about
    // one in a hundred. A second ray, five roundings beside the first, meets what is around it.
    std::optional<Meeting> meeting = meet(_scene->scene, query, from);
    const osg::Vec3d beside = anyNormal(query.ray.dir) * (5e-7 * _scene->radius);
    const std::optional<Meeting> second = meet(_scene->scene, query, from + beside);
    if (second && (!meeting || second->t < meeting->t - query.slack)) meeting = second;
    if (!meeting) return std::nullopt;

    const SceneTriangle& triangle = *meeting->triangle;
    const SceneSurface& surface = _scene->all.surfaces[triangle.surface];
    const Shares& shares = meeting->shares;
    SceneHit hit;
    hit.t = meeting->t;
    hit.point = meeting->point;
    hit.normal = areaVector(triangle);
    hit.normal.normalize();
    hit.colour = mixed<osg::Vec4>(triangle.colours, shares);
    if (surface.texture)
    {
        const osg::Vec4 texel = surface.texel(mixed<osg::Vec2d>(triangle.uvs, shares));
        for (int i = 0; i < 4; ++i)
            hit.colour[i] *= texel[i];
    }
    hit.writesDepth = surface.writesDepth;
    return hit;
}

bool SceneTracer::occluded(const osg::Vec3d& fromWorld, const osg::Vec3d& toWorld,
                           double clearance) const
{
    const osg::Vec3d way = toWorld - fromWorld;
    const std::optional<SceneHit> hit = trace(fromWorld, way, clearance);
    return hit && hit->t < way.length() - clearance;
}
