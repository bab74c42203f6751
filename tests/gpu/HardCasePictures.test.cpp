// Pictures of hard cases for docs/stability.md. tests/stability/pictures.py has them drawn by the
// library as it is and with the fault that a hard case is known for.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

using namespace osgWaterReflect;

namespace
{

void show(osg::Node* scene, const std::string& name)
{
    OffscreenView view(480, 270);
    view.camera().setClearColor(osg::Vec4(0.62, 0.74, 0.86, 1.0));
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<osg::Image> dry = copyOf(view.render(scenes::createHarbour()));
    const osg::Image& picture = view.render(scene);
    CHECK(countDifferent(picture, *dry) > 10000);
    keep(picture, name);
}

} // namespace

TEST_CASE("pictures of hard cases", "[.pictures]")
{
    const osg::ref_ptr<WaterSurface> water = scenes::createLake(0.0, 200.0);
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour(), water});

    show(scene, "hard-case-budget");

    const osg::ref_ptr<osg::Node> branch =
        scenes::createBox(scenes::HARBOUR_EYE + osg::Vec3d(-0.1, 1.5, -0.25),
                          osg::Vec3(1.6, 0.02, 0.03), osg::Vec4(0.25, 0.18, 0.1, 1));
    show(scenes::together({scene, branch}), "hard-case-branch");
}
