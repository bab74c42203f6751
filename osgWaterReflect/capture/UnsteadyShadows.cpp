#include "UnsteadyShadows.h"

#include <osg/NodeVisitor>
#include <osgShadow/ShadowedScene>

#include <cstring>

using namespace osgWaterReflect;

namespace
{

class FindUnsteadyShadows : public osg::NodeVisitor
{
public:
    FindUnsteadyShadows() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Group& group) override
    {
        if (found.empty()) found = unsteadyShadowsOf(group);
        if (found.empty()) osg::NodeVisitor::apply(group);
    }

    std::string found;
};

} // namespace

// By name: a dynamic_cast would have every application link osgShadow.
std::string osgWaterReflect::unsteadyShadowsOf(const osg::Group& group)
{
    if (std::strcmp(group.className(), "ShadowedScene") != 0 ||
        std::strcmp(group.libraryName(), "osgShadow") != 0)
        return {};
    const osg::Object* const technique =
        static_cast<const osgShadow::ShadowedScene&>(group).getShadowTechnique();
    const std::string name = technique ? technique->className() : "";
    return name.rfind("LightSpacePerspectiveShadowMap", 0) == 0 ? name : std::string();
}

std::string osgWaterReflect::unsteadyShadowsBelow(osg::Node& scene)
{
    FindUnsteadyShadows finder;
    scene.accept(finder);
    return finder.found;
}
