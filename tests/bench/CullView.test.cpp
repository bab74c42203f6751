// The scene that culls are measured in, and the view that culls it.

#include "support/Catch.h"

#include <osgwaterbench/render/CullView.h>
#include <osgwaterbench/scenes/CullScene.h>

#include <osg/Geode>
#include <osgUtil/Statistics>

#include <set>
#include <utility>

using namespace osgwaterbench;

namespace
{

const glm::ivec2 SIZE(1400, 1050); // [pixels]
const int WALK = 50;               // [steps] there and back

int drawablesInView(const CullView& view)
{
    osgUtil::Statistics statistics;
    view.stage().RenderBin::getStats(statistics);
    return statistics.numDrawables;
}

void look(CullView& view, int steps)
{
    const FieldEye eye = fieldEye(steps);
    view.setEye(eye.eye, eye.centre, eye.fovyDegrees);
    view.cull(0.0);
}

} // namespace

// Falls when a view keeps the leaves of the cull before or does not look along the eye's line. The
// field is 200 m by 300 m. From y = 14 m on, where the picture's lower edge is, the picture is
// wider by 2 x 0.566 m a metre, until it is as wide as the field: 35,800 of 60,000 square metres.
TEST_CASE("three in five of a field's boxes are in view")
{
    const osg::ref_ptr<osg::Group> field = createBoxField(10000, BoxStates::SHARED);
    CHECK(field->getNumChildren() == 10000);
    CullView view(*field, SIZE);
    for (int cull = 0; cull < 3; ++cull)
    {
        look(view, 0);
        CHECK(drawablesInView(view) == Approx(5970).margin(300)); // those cut by its edges: 200 m
    }
}

// Falls when boxes share what they are to have of their own, or share none.
TEST_CASE("a field's boxes share eight StateSets or have one each")
{
    for (const BoxStates states : {BoxStates::SHARED, BoxStates::OWN})
    {
        std::set<osg::StateSet*> found;
        const osg::ref_ptr<osg::Group> field = createBoxField(100, states);
        for (unsigned int i = 0; i < field->getNumChildren(); ++i)
            found.insert(field->getChild(i)->asGroup()->getChild(0)->getStateSet());
        CHECK(found.size() == (states == BoxStates::OWN ? 100 : 8));
    }
}

// Falls when the grid is wider or nearer than what is in view. As plain drawables: what water draws
// is the library's affair.
TEST_CASE("all waters of a field are in view wherever its eye is")
{
    const std::pair<WaterLayout, int> layouts[] = {
        {WaterLayout::ONE, 1}, {WaterLayout::IN_ONE_PLANE, 64}, {WaterLayout::ON_LEVELS, 64}};
    for (const auto& [layout, count] : layouts)
    {
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        for (const auto& water : createFieldWaters(layout))
        {
            const osg::ref_ptr<osg::Geode> plain = new osg::Geode;
            plain->addDrawable(water->getDrawable(0));
            scene->addChild(plain);
        }
        CullView view(*scene, SIZE);
        for (int steps = 0; steps < WALK; ++steps)
        {
            look(view, steps);
            CHECK(drawablesInView(view) == count);
        }
    }
}

// Falls when the walk goes on and on, or does not go at all.
TEST_CASE("the field's eye walks 2.5 m there and back")
{
    CHECK(fieldEye(0).eye == fieldEye(WALK).eye);
    CHECK((fieldEye(WALK / 2).eye - fieldEye(0).eye).length() == Approx(2.5));
}
