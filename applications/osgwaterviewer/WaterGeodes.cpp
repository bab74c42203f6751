#include "WaterGeodes.h"

#include <osg/NodeVisitor>

#include <set>
#include <typeinfo>

using namespace osgwaterviewer;

namespace
{

class FindWaterGeodes : public osg::NodeVisitor
{
public:
    FindWaterGeodes() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Geode& geode) override
    {
        if (geode.getName() == "water" && typeid(geode) == typeid(osg::Geode)) found.insert(&geode);
    }

    std::set<osg::ref_ptr<osg::Geode>> found; // one that is shared is met more than once
};

osg::ref_ptr<osgWaterReflect::WaterSurface> createWater(osg::Geode& geode)
{
    osg::ref_ptr<osgWaterReflect::WaterSurface> water = new osgWaterReflect::WaterSurface;
    water->setName(geode.getName());
    water->setNodeMask(geode.getNodeMask());
    for (unsigned int i = 0; i < geode.getNumDrawables(); ++i)
        water->addDrawable(geode.getDrawable(i));
    return water;
}

} // namespace

Waters osgwaterviewer::replaceWaterGeodes(osg::Group& root)
{
    FindWaterGeodes visitor;
    root.accept(visitor);

    Waters waters;
    for (const osg::ref_ptr<osg::Geode>& geode : visitor.found)
    {
        waters.push_back(createWater(*geode));
        const osg::Node::ParentList parents = geode->getParents(); // it shrinks meanwhile
        for (osg::Group* parent : parents)
            parent->replaceChild(geode, waters.back());
    }
    return waters;
}
