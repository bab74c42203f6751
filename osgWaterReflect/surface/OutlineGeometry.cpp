#include "OutlineGeometry.h"

#include "../Check.h"

#include <osg/io_utils>
#include <osgUtil/Tessellator>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

using Outline = std::vector<osg::Vec3>;

bool isFinite(const osg::Vec3& v)
{
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

// [1] Of the squared size: an area below this is rounding of corners in single precision.
const double NO_AREA = 1e-7;

// Twice the area that an outline encloses, along its normal [Newell].
osg::Vec3d areaVector(const Outline& outline)
{
    osg::Vec3d area;
    const osg::Vec3d origin(outline.front());
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        area += (osg::Vec3d(outline[i]) - origin) ^ (osg::Vec3d(outline[i + 1]) - origin);
    return area;
}

bool checkOutline(const char* member, const Outline& outline)
{
    if (outline.size() < 3) return refuse(member, "at least 3 corners", outline.size());
    for (const osg::Vec3& corner : outline)
        if (!isFinite(corner)) return refuse(member, "finite corners", corner);
    double squaredSize = 0.0;
    for (const osg::Vec3& corner : outline)
        squaredSize =
            std::max(squaredSize, (osg::Vec3d(corner) - osg::Vec3d(outline.front())).length2());
    const double area = 0.5 * areaVector(outline).length();
    return area > NO_AREA * squaredSize || refuse(member, "an outline with an area", area);
}

// It is never drawn itself: nothing is to be compiled for it.
osg::ref_ptr<osg::Geometry> createGeometry(osg::Vec3Array* vertices)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(false);
    geometry->setVertexArray(vertices);
    return geometry;
}

} // namespace

osg::ref_ptr<osg::Geometry> osgWaterReflect::createRectangleGeometry(const char* member,
                                                                     const osg::Vec3& centre,
                                                                     const osg::Vec3& lengthVec,
                                                                     const osg::Vec3& widthVec)
{
    for (const osg::Vec3& v : {centre, lengthVec, widthVec})
        if (!isFinite(v))
        {
            refuse(member, "finite vectors", v);
            return nullptr;
        }
    const osg::Vec3d length(lengthVec);
    const osg::Vec3d width(widthVec);
    const double area = (length ^ width).length();
    if (!(area > NO_AREA * length.length() * width.length()))
    {
        refuse(member, "sides that span an area", area);
        return nullptr;
    }

    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const osg::Vec3 corner = centre - (lengthVec + widthVec) * 0.5f;
    vertices->push_back(corner);
    vertices->push_back(corner + lengthVec);
    vertices->push_back(corner + lengthVec + widthVec);
    vertices->push_back(corner + widthVec);
    osg::ref_ptr<osg::Geometry> geometry = createGeometry(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    return geometry;
}

osg::ref_ptr<osg::Geometry>
osgWaterReflect::createPolygonGeometry(const char* member, const Outline& outline,
                                       const std::vector<Outline>& holes)
{
    if (!checkOutline(member, outline)) return nullptr;
    for (const Outline& hole : holes)
        if (!checkOutline(member, hole)) return nullptr;

    // The outline's own way round decides only where the plane is vertical.
    osg::Vec3d normal = areaVector(outline);
    if (normal.z() < -1e-6 * normal.length()) normal = -normal;
    normal.normalize();

    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Geometry> geometry = createGeometry(vertices);
    const auto addContour = [&](const Outline& contour)
    {
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_POLYGON, vertices->size(), contour.size()));
        vertices->insert(vertices->end(), contour.begin(), contour.end());
    };
    addContour(outline);
    for (const Outline& hole : holes)
        addContour(hole);

    osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
    tessellator->setTessellationType(osgUtil::Tessellator::TESS_TYPE_GEOMETRY);
    tessellator->setWindingType(osgUtil::Tessellator::TESS_WINDING_ODD);
    tessellator->setTessellationNormal(normal);
    tessellator->retessellatePolygons(*geometry);
    return geometry;
}
