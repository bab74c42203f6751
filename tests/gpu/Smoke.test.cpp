#include "support/Catch.h"
#include "support/OffscreenView.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/ShapeDrawable>

using osgWaterReflect::WaterSurface;

TEST_CASE("a box is reflected below itself")
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::ShapeDrawable> box =
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 5, 1), 2, 2, 2));
    box->setColor(osg::Vec4(1, 0, 0, 1));
    box->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    root->addChild(box);
    osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(100, 0, 0), osg::Vec3(0, 100, 0));
    water->setDebugView(WaterSurface::DebugView::REFLECTION);
    root->addChild(water);

    OffscreenView view(160, 120);
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 5, 0));
    const osg::Image& image = view.render(root);
    keep(image, "smoke");
    CHECK(pixel(image, 80, 62).r() == 1.0f); // the box itself
    CHECK(pixel(image, 80, 56).r() == 1.0f); // its reflection
}
