// What is hard about single pixels: rays that a wave sends down, colours that are no numbers,
// things under the water. docs/stability.md has the table of all hard cases.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/ShaderProbe.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/shaders/Bindings.h>

#include <osg/Program>

#include <cmath>
#include <random>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

osg::Vec3d unit(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    osg::Vec3d v(normal(random), normal(random), normal(random));
    v.normalize();
    return v;
}

osg::Vec3d xyz(const osg::Vec4& v)
{
    return osg::Vec3d(v.x(), v.y(), v.z());
}

// Answers of a function of reflected_ray.glsl, over level water in eye space's own axes.
std::vector<osg::Vec4> ask(const std::string& function, const std::vector<osg::Vec4>& first,
                           const std::vector<osg::Vec4>& second, float side)
{
    ShaderProbe probe("#include \"interface.glsl\"\n"
                      "#include \"reflected_ray.glsl\"\n"
                      "vec4 probe(vec4 first, vec4 second) { return vec4(" +
                      function + "(first.xyz, second.xyz), 0.0); }\n");
    bindings::set(probe.stateSet(), bindings::NORMAL_EYE_FROM_SURFACE, toOsgFloat(glm::dmat3(1.0)));
    bindings::set(probe.stateSet(), bindings::EYE_SIDE, side);
    return probe.run(first, second);
}

} // namespace

// Falls when reflectedDir returns `reflected`.
TEST_CASE("a ray that a wave sends down meets still water, and goes up")
{
    std::mt19937 random(7);
    std::vector<osg::Vec4> toEyes, normals;
    for (int i = 0; i < 5000; ++i)
    {
        toEyes.push_back(osg::Vec4(unit(random), 0));
        normals.push_back(osg::Vec4(unit(random), 0));
    }
    for (const float side : {1.0f, -1.0f})
    {
        const std::vector<osg::Vec4> dirs = ask("reflectedDir", toEyes, normals, side);
        int bounced = 0;
        for (std::size_t i = 0; i < dirs.size(); ++i)
        {
            const osg::Vec3d toEye = xyz(toEyes[i]);
            const osg::Vec3d normal = xyz(normals[i]);
            osg::Vec3d expected = normal * (2.0 * (normal * toEye)) - toEye;
            bounced += side * expected.z() < 0.0;
            expected.z() = side * std::abs(expected.z());
            CHECK((xyz(dirs[i]) - expected).length() < 1e-5);
        }
        CHECK(bounced > 1000);
    }
}

// Falls when facingNormal returns `normal`.
TEST_CASE("a normal that faces away from the eye is turned just so far that it does not")
{
    std::mt19937 random(8);
    std::vector<osg::Vec4> normals, toEyes;
    for (int i = 0; i < 5000; ++i)
    {
        osg::Vec3d normal = unit(random);
        normal.z() = std::abs(normal.z());
        normals.push_back(osg::Vec4(normal, 0));
        toEyes.push_back(osg::Vec4(unit(random), 0));
    }
    const std::vector<osg::Vec4> turned = ask("facingNormal", normals, toEyes, 1.0f);
    int away = 0;
    for (std::size_t i = 0; i < turned.size(); ++i)
    {
        const osg::Vec3d normal = xyz(normals[i]);
        const double facing = normal * xyz(toEyes[i]);
        away += facing < 0.0;
        CHECK(std::abs(xyz(turned[i]).length() - 1.0) < 1e-5);
        CHECK(xyz(turned[i]) * xyz(toEyes[i]) > -1e-5);
        if (facing >= 0.0) CHECK((xyz(turned[i]) - normal).length() < 1e-5);
    }
    CHECK(away > 1000);
}

// Falls when finiteColour returns `colour`.
TEST_CASE("NaN and infinity of the scene's colours do not spread over the water")
{
    const osg::ref_ptr<osg::Node> wall = scenes::createQuad(
        osg::Vec3(-8, 6, -1), osg::Vec3(16, 0, 0), osg::Vec3(0, 0, 5), osg::Vec4(1, 1, 1, 1));
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       "#version 130\n"
                                       "uniform float zero;\n"
                                       "void main()\n"
                                       "{\n"
                                       "    gl_FragColor = vec4(zero / zero, 1.0 / zero,\n"
                                       "                        -1.0 / zero, 1.0);\n"
                                       "}\n"));
    wall->getOrCreateStateSet()->setAttributeAndModes(program);
    wall->getOrCreateStateSet()->addUniform(new osg::Uniform("zero", 0.0f));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> scene = scenes::together({wall, lake});
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 0.5));

    lake->setDebugView(DebugView::HIT);
    const osg::ref_ptr<osg::Image> hits = copyOf(view.render(scene));
    lake->setDebugView(DebugView::NONE);
    const osg::Image& picture = view.render(scene);
    int reflecting = 0;
    int notFinite = 0;
    for (int y = 0; y < view.height(); ++y)
        for (int x = 0; x < view.width(); ++x)
        {
            const osg::Vec4 hit = pixel(*hits, x, y);
            if (!(hit.x() >= 0.0f && hit.z() == 0.0f && hit.w() > 1.0f)) continue;
            ++reflecting;
            const osg::Vec4 colour = pixel(picture, x, y);
            for (int i = 0; i < 3; ++i)
                notFinite += !std::isfinite(colour[i]);
        }
    CHECK(reflecting > 1000);
    CHECK(notFinite == 0);
}

// Falls when shadeWater takes the refractive index from either side as it is.
TEST_CASE("an eye under the water sees it reflect everything beyond 48.6 degrees")
{
    const osg::ref_ptr<osg::Group> scene = scenes::createHarbour();
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    scene->addChild(lake);
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    // Farther than 2.3 m every pixel of water is seen at more than that.
    view.look(osg::Vec3d(0, -14, -2), osg::Vec3d(0, 0, -1.5));
    lake->setDebugView(DebugView::POINT);
    const osg::ref_ptr<osg::Image> points = copyOf(view.render(scene));
    lake->setDebugView(DebugView::REFLECTION);
    const osg::ref_ptr<osg::Image> reflection = copyOf(view.render(scene));
    lake->setDebugView(DebugView::NONE);
    const osg::Image& picture = view.render(scene);
    int water = 0;
    int different = 0;
    for (int y = 0; y < view.height(); ++y)
        for (int x = 0; x < view.width(); ++x)
        {
            if (pixel(*points, x, y).w() != -1.0f || pixel(*points, x, y).z() > -3.0f) continue;
            ++water;
            different += (pixel(picture, x, y) - pixel(*reflection, x, y)).length() > 1e-5;
        }
    CHECK(water > 2000);
    CHECK(different == 0);
}

// Falls when lookFor leaves out REASON_BELOW_WATER.
TEST_CASE("what stands under the water is not reflected, though seen through a crest")
{
    // Walls that troughs lay bare and crests cover, one behind the other.
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (double y = -8.0; y < 30.0; y += 0.7)
        scene->addChild(scenes::createQuad(osg::Vec3(-40, y, -2), osg::Vec3(80, 0, 0),
                                           osg::Vec3(0, 0, 2.1), osg::Vec4(1, 0, 0, 1)));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setWaves(TrochoidalWaves::createBreeze(4.0, 0.6));
    scene->addChild(lake);
    OffscreenView view(160, 120, OffscreenView::Format::RGBA32F);
    view.look(osg::Vec3d(0, -10, 1.0), osg::Vec3d(0, 0, 0.5));
    lake->setDebugView(DebugView::HIT);
    const osg::ref_ptr<osg::Image> hits = copyOf(view.render(scene));
    lake->setDebugView(DebugView::REFLECTION);
    const osg::Image& reflection = view.render(scene);
    int below = 0;
    int red = 0;
    for (int y = 0; y < view.height(); ++y)
        for (int x = 0; x < view.width(); ++x)
        {
            if (pixel(*hits, x, y).z() != 8.0f) continue;
            ++below;
            red += pixel(reflection, x, y).r() > 0.9f;
        }
    CHECK(below > 50);
    CHECK(red == 0);
}
