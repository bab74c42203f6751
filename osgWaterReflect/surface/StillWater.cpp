#include "StillWater.h"

#include "../Transforms.h"
#include "ConvexHull.h"

#include <osg/Notify>
#include <osg/TriangleFunctor>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

using namespace osgWaterReflect;

namespace
{

struct CollectTriangles
{
    std::vector<glm::dvec3> corners;

    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        for (const osg::Vec3& corner : {a, b, c})
            corners.push_back(fromOsg(osg::Vec3d(corner)));
    }
};

glm::dvec3 areaVector(const glm::dvec3* triangle)
{
    return 0.5 * glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

// Rigid frame of a plane through a point, as StillWater describes it.
glm::dmat4 planeFrame(const glm::dvec3& normal, const glm::dvec3& point)
{
    const glm::dvec3 xAxis(1.0, 0.0, 0.0);
    const glm::dvec3 yAxis(0.0, 1.0, 0.0);
    const glm::dvec3 along = std::abs(glm::dot(normal, xAxis)) < 0.9 ? xAxis : yAxis;
    const glm::dvec3 x = glm::normalize(along - glm::dot(along, normal) * normal);
    const glm::dvec3 y = glm::cross(normal, x);
    const glm::dvec3 origin = glm::dot(point, normal) * normal;
    return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(normal, 0.0),
                      glm::dvec4(origin, 1.0));
}

// Triangles sorted by the planes that they lie in, to within what single precision makes of their
// corners, whichever side they face. Those without an area lie in no plane of their own.
std::vector<std::vector<glm::dvec3>> splitByPlane(const std::vector<glm::dvec3>& points)
{
    double extent = 0.0;
    std::vector<std::pair<double, std::size_t>> byArea; // and the first point's index
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
        for (std::size_t corner = i; corner < i + 3; ++corner)
            extent = std::max(extent, glm::length(points[corner]));
        const double area = glm::length(areaVector(&points[i]));
        if (area > 0.0) byArea.push_back({area, i});
    }
    // The largest first: a sliver's plane is that of its neighbours, not what its corners' rounding
    // makes of it.
    std::stable_sort(byArea.begin(), byArea.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });

    const double tolerance = 1e-5 * extent;            // a hundred roundings of the farthest corner
    std::vector<std::pair<glm::dvec3, double>> planes; // unit normal, distance from the origin
    std::vector<std::vector<glm::dvec3>> split;
    for (const auto& [area, first] : byArea)
    {
        std::size_t i = 0;
        const auto holds = [&](const auto& plane)
        {
            bool inside = true;
            for (std::size_t corner = first; corner < first + 3; ++corner)
                inside = inside && std::abs(glm::dot(plane.first, points[corner]) - plane.second) <=
                                       tolerance;
            return inside;
        };
        while (i < planes.size() && !holds(planes[i]))
            ++i;
        if (i == planes.size())
        {
            const glm::dvec3 normal = glm::normalize(areaVector(&points[first]));
            planes.push_back({normal, glm::dot(normal, points[first])});
            split.emplace_back();
            if (planes.size() > StillWater::MAX_PLANES) return split;
        }
        split[i].insert(split[i].end(), points.begin() + first, points.begin() + first + 3);
    }
    return split;
}

} // namespace

osg::ref_ptr<osg::Geometry> osgWaterReflect::createSurfaceGeometry()
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(new osg::Vec3Array);
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES));
    return geometry;
}

std::vector<osg::ref_ptr<StillWater>> StillWater::createSheets(osg::Drawable& drawable)
{
    osg::TriangleFunctor<CollectTriangles> collect;
    drawable.accept(collect);

    std::vector<std::vector<glm::dvec3>> planes = splitByPlane(collect.corners);
    if (planes.size() > MAX_PLANES)
    {
        OSG_WARN << "WaterSurface: expected a drawable of at most " << MAX_PLANES
                 << " planes, got more; the water is laid in the mean plane" << std::endl;
        planes = {collect.corners};
    }
    std::vector<osg::ref_ptr<StillWater>> sheets;
    for (const std::vector<glm::dvec3>& points : planes)
        if (osg::ref_ptr<StillWater> sheet = create(points)) sheets.push_back(sheet);
    return sheets;
}

osg::ref_ptr<StillWater> StillWater::create(const std::vector<glm::dvec3>& points)
{
    glm::dvec3 area(0.0);
    glm::dvec3 centre(0.0);
    for (std::size_t i = 0; i < points.size(); i += 3)
        area += areaVector(&points[i]);
    for (const glm::dvec3& point : points)
        centre += point / static_cast<double>(points.size());
    if (!(glm::length(area) > 0.0)) return nullptr;

    osg::ref_ptr<StillWater> water = new StillWater;
    water->_localFromSurface = planeFrame(glm::normalize(area), centre);
    water->addTriangles(points);
    water->_hull = convexHull(water->_corners);
    water->createCalmMesh();
    return water;
}

void StillWater::addTriangles(const std::vector<glm::dvec3>& points)
{
    const glm::dmat4 surfaceFromLocal = glm::inverse(_localFromSurface);

    // Corners that coincide become one, so that neighbours split a common edge at one place.
    std::map<std::tuple<double, double, double>, unsigned int> indexOf;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const glm::dvec3& point = points[i];
        const auto added = indexOf.emplace(std::make_tuple(point.x, point.y, point.z),
                                           static_cast<unsigned int>(indexOf.size()));
        if (added.second)
        {
            const glm::dvec3 surface = surfaceFromLocal * glm::dvec4(point, 1.0);
            const glm::dvec3 inPlane = _localFromSurface * glm::dvec4(surface.x, surface.y, 0, 1);
            _corners.push_back(glm::dvec2(surface));
            _stillBound.expandBy(toOsg(inPlane));
        }
        _triangles.push_back(added.first->second);

        // A triangle with a corner twice has no inside, and would count as a neighbour.
        if (i % 3 != 2) continue;
        const std::size_t last = _triangles.size() - 1;
        const unsigned int* corner = &_triangles[last - 2];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            _triangles.resize(last - 2);
    }
}

void StillWater::createCalmMesh()
{
    for (const glm::dvec2& corner : _corners)
        _calmAnchor += corner / static_cast<double>(_corners.size());
    _calmMesh = createSurfaceGeometry();
    auto* vertices = static_cast<osg::Vec3Array*>(_calmMesh->getVertexArray());
    auto* indices = static_cast<osg::DrawElementsUInt*>(_calmMesh->getPrimitiveSet(0));
    for (const glm::dvec2& corner : _corners)
        vertices->push_back(osg::Vec3(corner.x - _calmAnchor.x, corner.y - _calmAnchor.y, 0.0f));
    indices->assign(_triangles.begin(), _triangles.end());
}

double StillWater::squaredDistance(const glm::dvec3& localPoint) const
{
    // The frame is rigid.
    const glm::dvec3 surfacePoint = glm::inverse(_localFromSurface) * glm::dvec4(localPoint, 1.0);
    const glm::dvec2 place(surfacePoint);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < _triangles.size(); i += 3)
    {
        int insides = 0; // edges that have the place to their left, less those to their right
        for (int edge = 0; edge < 3; ++edge)
        {
            const glm::dvec2 start = _corners[_triangles[i + edge]];
            const glm::dvec2 along = _corners[_triangles[i + (edge + 1) % 3]] - start;
            const glm::dvec2 offset = place - start;
            insides += along.x * offset.y - along.y * offset.x >= 0.0 ? 1 : -1;
            const double length2 = glm::dot(along, along);
            const double part = std::clamp(glm::dot(offset, along) / length2, 0.0, 1.0);
            const glm::dvec2 toEdge = offset - part * along;
            nearest = std::min(nearest, glm::dot(toEdge, toEdge));
        }
        if (std::abs(insides) == 3) nearest = 0.0;
    }
    return nearest + surfacePoint.z * surfacePoint.z;
}

osg::BoundingBox StillWater::localBound(double amplitude) const
{
    const osg::Vec3 margin(toOsg(amplitude * glm::abs(glm::dvec3(_localFromSurface[2]))));
    return osg::BoundingBox(_stillBound._min - margin, _stillBound._max + margin);
}
