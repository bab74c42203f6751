#include "CullPair.h"

using namespace osgwaterbench;

namespace
{

osg::ref_ptr<osg::Group> withWaters(osg::Group& field, const CullPair::Waters& waters)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(&field);
    for (const auto& water : waters)
        scene->addChild(water);
    return scene;
}

} // namespace

CullPair::CullPair(osg::Group& field, const Waters& waters, const glm::ivec2& size) :
    _dry(*withWaters(field, {}), size), _wet(*withWaters(field, waters), size)
{
}

void CullPair::prepare(const FieldEye& eye, double time)
{
    for (CullView* view : {&_dry, &_wet})
        view->setEye(eye.eye, eye.centre, eye.fovyDegrees);
    _time = time;
}

void CullPair::cullDry()
{
    _dry.cull(_time);
}

void CullPair::cullWet()
{
    _wet.cull(_time);
}
