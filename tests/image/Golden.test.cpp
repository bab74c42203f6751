#include "support/Catch.h"
#include "support/OffscreenView.h"

#include "Sky.h"
#include "WaterGeodes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osgDB/ReadFile>

#include <cstdlib>

// Pictures that were looked at, and found right, once. Each is compared with the stored one: a
// pixel may differ by 8 of 255, for processors round differently, and 0.5 % of the pixels by more,
// where a rounding has moved a ray from one side of a silhouette to the other. Breaking any sign in
// the shaders changes tenths of the picture.
//
// GOLDEN_UPDATE=1 build/bin/test_image writes them anew; look at them before you commit them.

using osgWaterReflect::TrochoidalWaves;
using osgWaterReflect::WaterSurface;

namespace
{

struct GoldenView
{
    const char* name;
    const char* scene;
    osg::Vec3d eye;
    osg::Vec3d centre;
    double fovyDegrees;
    double steepness; // of the waves; 0 for calm water
};

std::string dataFile(const std::string& name)
{
    return std::string(OSGWATERREFLECT_DATA_DIRECTORY) + "/" + name;
}

osg::ref_ptr<osg::Group> createScene(const GoldenView& view)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(osgDB::readRefNodeFile(dataFile(view.scene)));
    const osg::ref_ptr<osg::TextureCubeMap> sky = osgwaterviewer::readSky(dataFile("sky"));
    const osgwaterviewer::Waters waters = osgwaterviewer::replaceWaterGeodes(*root);
    REQUIRE(waters.size() == 1);
    waters[0]->setSky(sky);
    if (view.steepness > 0.0)
        waters[0]->setWaves(TrochoidalWaves::createBreeze(2.0, view.steepness));
    return root;
}

void compareWithGolden(const osg::Image& image, const std::string& name)
{
    const std::string file =
        std::string(OSGWATERREFLECT_TEST_DIRECTORY) + "/image/golden/" + name + ".png";
    if (std::getenv("GOLDEN_UPDATE")) writeImage(image, file);
    const osg::ref_ptr<osg::Image> golden = osgDB::readRefImageFile(file);
    REQUIRE(golden);
    const int pixels = image.s() * image.t();
    const int different = countDifferent(image, *golden, 8.5 / 255.0);
    INFO(different << " of " << pixels << " pixels differ from " << file);
    CHECK(different <= 0.005 * pixels);
}

} // namespace

TEST_CASE("pictures are as they were when they were looked at")
{
    const osg::Vec3d hero(0, -30, 2.2), village(0, 0, 2.6);
    const GoldenView views[] = {
        {"lake-calm", "lake.osgb", hero, village, 46.0, 0.0},
        {"lake-moving", "lake.osgb", hero, village, 46.0, 0.12},
        {"puddle", "street.osgb", {-6.2, -3.6, 1.6}, {0.4, 4, 1.35}, 50.0, 0.0},
        {"afloat", "lake.osgb", {-0.5, -26.9, 1.1}, {0.3, -21, 0.4}, 50.0, 0.08},
    };
    for (const GoldenView& view : views)
        DYNAMIC_SECTION(view.name)
        {
            OffscreenView offscreen(320, 240);
            offscreen.look(view.eye, view.centre, view.fovyDegrees);
            const osg::Image& image = offscreen.render(createScene(view), 3.0);
            keep(image, view.name);
            compareWithGolden(image, view.name);
        }
}
