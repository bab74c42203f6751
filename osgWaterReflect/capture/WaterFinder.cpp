#include "WaterFinder.h"

#include <osg/Billboard>
#include <osg/Camera>
#include <osgShadow/ShadowedScene>

using namespace osgWaterReflect;

namespace
{

// By name: a dynamic_cast would have every application link osgShadow.
const osgShadow::ShadowedScene* asShadowedScene(const osg::Group& group)
{
    const bool shadowed = std::string("ShadowedScene") == group.className() &&
                          std::string("osgShadow") == group.libraryName();
    return shadowed ? static_cast<const osgShadow::ShadowedScene*>(&group) : nullptr;
}

} // namespace

const std::vector<SeenWater>& WaterFinder::find(osgUtil::CullVisitor& view)
{
    _seen.clear();
    _unsteadyShadows.clear();
    const osg::ref_ptr<osg::RefMatrix> projection = new osg::RefMatrix(*view.getProjectionMatrix());
    const osg::ref_ptr<osg::Viewport> viewport = new osg::Viewport(*view.getViewport());
    cull(view, *_stage, osg::Matrixd(), *projection, *viewport);
    finish(*_stage);
    return _seen;
}

void WaterFinder::meet(const WaterSurface& water,
                       const std::vector<osg::ref_ptr<StillWater>>& sheets)
{
    const WaveModel* const waves = water.getWaves();
    SeenWater seen{&water, {}};
    for (const osg::ref_ptr<StillWater>& sheet : sheets)
        if (!isCulled(sheet->localBound(waves ? waves->getAmplitude() : 0.0)))
            seen.mirroredEyes.push_back(mirroredEye(*this, water, *sheet));
    if (!seen.mirroredEyes.empty()) _seen.push_back(seen);
}

// Past the shadow technique, which would cull the scene for its shadows.
void WaterFinder::apply(osg::Group& group)
{
    const osgShadow::ShadowedScene* const shadowed = asShadowedScene(group);
    if (!shadowed) return CaptureVisitor::apply(group);
    if (isCulled(group)) return;
    const osg::Object* const technique = shadowed->getShadowTechnique();
    const std::string name = technique ? technique->className() : "";
    if (name.rfind("LightSpacePerspectiveShadowMap", 0) == 0) _unsteadyShadows = name;
    pushCurrentMask();
    group.osg::Group::traverse(*this);
    popCurrentMask();
}

void WaterFinder::apply(osg::Camera& camera)
{
    if (camera.getRenderOrder() == osg::Camera::NESTED_RENDER) CaptureVisitor::apply(camera);
}

void WaterFinder::apply(osg::Geode& geode)
{
    if (dynamic_cast<WaterSurface*>(&geode)) CaptureVisitor::apply(geode);
}
