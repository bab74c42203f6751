// WaterSurface as a node: what it takes for children, and what it makes of them.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/Geometry>
#include <osg/NodeVisitor>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<osg::Geometry> createSquare(double level)
{
    return osg::createTexturedQuadGeometry(osg::Vec3(-1, -1, level), osg::Vec3(2, 0, 0),
                                           osg::Vec3(0, 2, 0));
}

} // namespace

// Breaks where one of WaterSurface's four overrides is taken away.
TEST_CASE("water refuses children that are no drawables, and keeps those that it has")
{
    const osg::ref_ptr<WaterSurface> water = new WaterSurface;
    const osg::ref_ptr<osg::Geometry> square = createSquare(0.0);
    REQUIRE(water->addChild(square));
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    const osg::ref_ptr<osg::Node> none;
    Refusals refusals;

    for (const osg::ref_ptr<osg::Node>& child : {osg::ref_ptr<osg::Node>(group), none})
    {
        CHECK_FALSE(water->addChild(child));
        CHECK(isRefusalOf("WaterSurface::addChild", refusals.take()));
        CHECK_FALSE(water->insertChild(0, child));
        CHECK(isRefusalOf("WaterSurface::insertChild", refusals.take()));
        CHECK_FALSE(water->setChild(0, child));
        CHECK(isRefusalOf("WaterSurface::setChild", refusals.take()));
        CHECK_FALSE(water->replaceChild(square, child));
        CHECK(isRefusalOf("WaterSurface::replaceChild", refusals.take()));
    }
    CHECK_FALSE(water->addDrawable(nullptr));
    CHECK(isRefusalOf("WaterSurface::addChild", refusals.take()));
    CHECK_FALSE(water->setDrawable(0, nullptr));
    CHECK(isRefusalOf("WaterSurface::setChild", refusals.take()));
    CHECK_FALSE(water->replaceDrawable(square, nullptr));
    CHECK(isRefusalOf("WaterSurface::replaceChild", refusals.take()));
    CHECK(group->getNumParents() == 0);
    CHECK(water->getNumChildren() == 1);
    CHECK(water->getDrawable(0) == square);

    // In every way that a Geode takes drawables.
    const osg::ref_ptr<osg::Geometry> other = createSquare(1.0);
    CHECK(water->insertChild(0, other));
    CHECK(water->replaceChild(other, createSquare(2.0)));
    CHECK(water->setDrawable(0, other));
    CHECK(water->addDrawable(createSquare(3.0)));
    CHECK(water->replaceDrawable(other.get(), createSquare(4.0).get()));
    CHECK(water->getNumDrawables() == 3);
    CHECK(refusals.take().empty());
}

// osg::Group's own function can be called past WaterSurface's. Crashes where computeBound takes
// every child for a drawable.
TEST_CASE("a child that is no drawable is no water, and does no harm")
{
    const osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->addDrawable(createSquare(0.0));
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createSquare(7.0));
    REQUIRE(water->osg::Group::addChild(group.get()));
    CHECK(water->getBound().valid());
    water->releaseGLObjects();
    water->resizeGLObjectBuffers(4);
    osg::NodeVisitor visitor(osg::NodeVisitor::TRAVERSE_ALL_CHILDREN);
    water->accept(visitor);
}
