#include "Bake.h"

#include "LightBaker.h"
#include "Normals.h"
#include "Subdivide.h"

#include <osg/Geode>
#include <osgUtil/MeshOptimizers>

namespace waterdata
{

namespace
{

osg::ref_ptr<osg::Geometry> paintedGeometry(const Mesh& mesh)
{
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> paints = new osg::Vec4Array;
    for (const Triangle& triangle : mesh.triangles)
    {
        for (int corner = 0; corner < 3; ++corner)
        {
            points->push_back(triangle.corners[corner]);
            paints->push_back(osg::Vec4(triangle.colours[corner], 1.0f));
        }
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(mesh.name);
    geometry->setVertexArray(points);
    geometry->setColorArray(paints, osg::Array::BIND_PER_VERTEX);
    const std::vector<osg::Vec3> normals = cornerNormals(mesh);
    geometry->setNormalArray(new osg::Vec3Array(normals.begin(), normals.end()),
                             osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, points->size()));
    osgUtil::IndexMeshVisitor().makeMesh(*geometry);
    return geometry;
}

// Light is in the colours now: the normals have done their work, and bytes are fine enough.
void compact(osg::Geometry& geometry)
{
    const auto& colours = static_cast<const osg::Vec4Array&>(*geometry.getColorArray());
    osg::ref_ptr<osg::Vec4ubArray> bytes = new osg::Vec4ubArray;
    bytes->setNormalize(true);
    for (const osg::Vec4& paint : colours)
    {
        const osg::Vec4 rounded = paint * 255.0f + osg::Vec4(0.5f, 0.5f, 0.5f, 0.5f);
        bytes->push_back(osg::Vec4ub(rounded.x(), rounded.y(), rounded.z(), rounded.w()));
    }
    geometry.setColorArray(bytes, osg::Array::BIND_PER_VERTEX);
    geometry.setNormalArray(nullptr);
    osgUtil::IndexMeshVisitor().makeMesh(geometry);
    osgUtil::VertexCacheVisitor().optimizeVertices(geometry);
    osgUtil::VertexAccessOrderVisitor().optimizeOrder(geometry);
    geometry.setUseDisplayList(false);
    geometry.setUseVertexBufferObjects(true);
}

}

osg::ref_ptr<osg::Group> bakeScene(std::vector<Mesh> meshes, const Daylight& daylight,
                                   const osg::Vec3& focus)
{
    std::vector<BakeItem> items;
    for (Mesh& mesh : meshes)
    {
        subdivide(mesh, focus);
        items.push_back({paintedGeometry(mesh), mesh.leafy});
    }
    bakeLight(items, daylight);

    osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (const BakeItem& item : items)
    {
        compact(*item.geometry);
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(item.geometry->getName());
        geode->addDrawable(item.geometry);
        scene->addChild(geode);
    }
    scene->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return scene;
}

}
