#include "WaterSurface.h"

#include "Arrays.h"
#include "RayScene.h"

#include <osg/Geometry>
#include <osgUtil/Tessellator>

namespace waterdata
{

osg::ref_ptr<osg::Geode> waterSurface(const std::vector<osg::Vec3>& outline)
{
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array(outline.begin(), outline.end());
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName("water");
    geometry->setVertexArray(points);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_POLYGON, 0, points->size()));

    osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
    tessellator->setTessellationType(osgUtil::Tessellator::TESS_TYPE_GEOMETRY);
    tessellator->setTessellationNormal(osg::Vec3(0.0f, 0.0f, 1.0f));
    tessellator->retessellatePolygons(*geometry);
    const std::vector<unsigned int> corners = triangleCorners(*geometry);
    geometry->removePrimitiveSet(0, geometry->getNumPrimitiveSets());
    geometry->addPrimitiveSet(
        new osg::DrawElementsUShort(GL_TRIANGLES, corners.begin(), corners.end()));

    geometry->setNormalArray(only<osg::Vec3Array>({0.0f, 0.0f, 1.0f}), osg::Array::BIND_OVERALL);
    geometry->setColorArray(only<osg::Vec4Array>({0.16f, 0.27f, 0.31f, 1.0f}),
                            osg::Array::BIND_OVERALL);

    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("water");
    geode->addDrawable(geometry);
    return geode;
}

}
