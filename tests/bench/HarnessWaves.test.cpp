// osgwaterbench's flat water with the normals of waves, in GLSL against double precision.

#include "support/Catch.h"
#include "support/ShaderProbe.h"

#include <osgwaterbench/methods/Methods.h>
#include <osgwaterbench/scenes/HarnessWaves.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using osgwaterbench::HarnessWaves;

TEST_CASE("harness waves have the same normals in GLSL, at height 0")
{
    const osg::ref_ptr<HarnessWaves> waves = new HarnessWaves;
    osgWaterReflect::ShaderSlots slots;
    slots.waves = waves->getShaderPiece();
    ShaderProbe probe("#include \"waves.glsl\"\n"
                      "vec4 probe(vec4 first, vec4 second)\n"
                      "{\n"
                      "    return vec4(normalOf(waveSlope(first.xy, second.xy, second.zw).mean),\n"
                      "                waveHeight(first.xy));\n"
                      "}\n",
                      slots);
    REQUIRE(waves->setWaves({{{0.8, 0.6}, 3.0, 0.0, 1.0}, {{-0.4, 0.9}, 5.0, 1.0, 0.6}}, 0.15));
    for (const osg::Vec2d& anchor : {osg::Vec2d(0, 0), osg::Vec2d(48000.3, -7.7)})
    {
        waves->createState(0.0)->apply(probe.stateSet(), anchor);
        std::vector<osg::Vec4> places, footprints;
        for (int i = 0; i < 500; ++i)
        {
            places.push_back(osg::Vec4(0.11f * i - 20.0f, 0.07f * i, 0, 0));
            footprints.push_back(osg::Vec4(0.001f * i, 0, 0, 0.01f * i)); // they change nothing
        }
        const std::vector<osg::Vec4> answers = probe.run(places, footprints);
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            const osg::Vec3d normal =
                waves->getNormal(anchor + osg::Vec2d(places[i].x(), places[i].y()), 0.0);
            const osg::Vec3d answer(answers[i].x(), answers[i].y(), answers[i].z());
            // Single precision of phases of some hundred radians, times the slope.
            CHECK((answer - normal).length() < 1e-5);
            CHECK(answers[i].w() == 0.0f);
        }
    }
}

// Falls when getMaxSlope leaves out the slope, or a wave's sign.
TEST_CASE("harness waves get as steep as the stated bound, and no steeper")
{
    const osg::ref_ptr<HarnessWaves> waves = new HarnessWaves;
    CHECK(waves->getMaxSlope() == 0.0);
    REQUIRE(waves->setWaves({{{0.8, 0.6}, 3.0, 0.0, 1.0}, {{-0.4, 0.9}, 4.7, 1.0, -0.6}}, 0.15));
    double steepest = 0.0;
    for (int i = 0; i < 100000; ++i)
    {
        const osg::Vec3d normal = waves->getNormal(osg::Vec2d(0.37 * i, 0.11 * i), 0.0);
        steepest = std::max(steepest, std::hypot(normal.x(), normal.y()) / normal.z());
    }
    CHECK(steepest <= waves->getMaxSlope() * (1.0 + 1e-12));
    CHECK(steepest > 0.99 * waves->getMaxSlope());
}
