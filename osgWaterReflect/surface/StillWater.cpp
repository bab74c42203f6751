#include "StillWater.h"

#include "../Transforms.h"

#include <osg/Notify>
#include <osg/TriangleFunctor>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

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

osg::ref_ptr<StillWater> StillWater::create(osg::Drawable& drawable)
{
    osg::TriangleFunctor<CollectTriangles> collect;
    drawable.accept(collect);
    const std::vector<glm::dvec3>& points = collect.corners;

    glm::dvec3 area(0.0);
    glm::dvec3 centre(0.0);
    for (std::size_t i = 0; i < points.size(); i += 3)
        area += areaVector(&points[i]);
    for (const glm::dvec3& point : points)
        centre += point / static_cast<double>(points.size());
    if (!(glm::length(area) > 0.0)) return nullptr;

    osg::ref_ptr<StillWater> water = new StillWater;
    water->_localFromSurface = planeFrame(glm::normalize(area), centre);
    const double offPlane = water->addTriangles(points);
    // Single precision leaves far less than a thousandth of the size; more is a shape.
    if (offPlane > 1e-3 * std::sqrt(glm::length(area)))
        OSG_WARN
            << "WaterSurface: expected a plane drawable, got one that leaves its mean plane by "
            << offPlane << "; the water is laid in the mean plane" << std::endl;
    water->createCalmMesh();
    return water;
}

double StillWater::addTriangles(const std::vector<glm::dvec3>& points)
{
    const glm::dmat4 surfaceFromLocal = glm::inverse(_localFromSurface);
    double offPlane = 0.0;

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
            offPlane = std::max(offPlane, std::abs(surface.z));
        }
        _triangles.push_back(added.first->second);

        // A triangle with a corner twice has no inside, and would count as a neighbour.
        if (i % 3 != 2) continue;
        const std::size_t last = _triangles.size() - 1;
        const unsigned int* corner = &_triangles[last - 2];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            _triangles.resize(last - 2);
    }
    return offPlane;
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

osg::BoundingBox StillWater::localBound(double amplitude) const
{
    const osg::Vec3 margin(toOsg(amplitude * glm::abs(glm::dvec3(_localFromSurface[2]))));
    return osg::BoundingBox(_stillBound._min - margin, _stillBound._max + margin);
}
