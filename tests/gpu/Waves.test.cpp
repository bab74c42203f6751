// The waves on the GPU, in single precision, against the same waves on the CPU.

#include "support/Catch.h"
#include "support/Scenes.h"
#include "support/ShaderProbe.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/shaders/Bindings.h>
#include <osgWaterReflect/waves/TrochoidalSum.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace osgWaterReflect;

namespace
{

const double PI = 3.14159265358979323846;

osg::ref_ptr<TrochoidalWaves> wavesOf(const std::vector<TrochoidalWave>& list)
{
    osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves(list));
    return waves;
}

ShaderSlots waveSlot(const WaveModel& waves)
{
    ShaderSlots slots;
    slots.waves = waves.getShaderPiece();
    return slots;
}

const char* const NORMAL_AND_HEIGHT =
    "#include \"waves.glsl\"\n"
    "vec4 probe(vec4 first, vec4 second)\n"
    "{\n"
    "    return vec4(normalOf(waveSlope(first.xy, second.xy, second.zw).mean),\n"
    "                waveHeight(first.xy));\n"
    "}\n";

ShaderProbe& waveProbe()
{
    static ShaderProbe probe(NORMAL_AND_HEIGHT, waveSlot(*wavesOf({})));
    return probe;
}

TrochoidalWave steepWave(double steepness, double length, double directionDegrees)
{
    TrochoidalWave wave;
    wave.amplitude = steepness * length / (2.0 * PI);
    wave.length = length;
    wave.directionDegrees = directionDegrees;
    wave.phase = 0.7 * directionDegrees;
    return wave;
}

struct System
{
    const char* name;
    osg::ref_ptr<TrochoidalWaves> waves;
};

// Wave systems of a steepness sum: what createBreeze gives, and the two worst for Newton's method.
std::vector<System> systems(double steepness)
{
    const double third = steepness / 3.0;
    return {{"breeze", TrochoidalWaves::createBreeze(4.0, steepness)},
            {"one wave", wavesOf({steepWave(steepness, 2.0, 37.0)})},
            {"three waves", wavesOf({steepWave(third, 2.0, 0.0), steepWave(third, 0.6, 30.0),
                                     steepWave(third, 0.18, 60.0)})}};
}

struct Errors
{
    double height = 0.0; // of the sum of amplitudes
    double degrees = 0.0;
};

// The shader's errors at the 99.9th percentile of places within a distance of the anchor.
Errors measure(const TrochoidalWaves& waves, int steps, const osg::Vec2d& anchor, double time,
               double distance = 30.0)
{
    ShaderProbe& probe = waveProbe();
    waves.createState(time)->apply(probe.stateSet(), anchor);
    if (steps > 0) bindings::set(probe.stateSet(), "osgwr_waveNewtonSteps", steps);

    std::mt19937 random(11);
    std::uniform_real_distribution<float> anywhere(-distance, distance);
    std::vector<osg::Vec4> places;
    for (int i = 0; i < 20000; ++i)
        places.push_back(osg::Vec4(anywhere(random), anywhere(random), 0, 0));
    const std::vector<osg::Vec4> answers = probe.run(places);

    std::vector<double> heights;
    std::vector<double> angles;
    double reach = 0.0;
    for (const TrochoidalWave& wave : waves.getWaves())
        reach += wave.amplitude;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const osg::Vec2d place = anchor + osg::Vec2d(places[i].x(), places[i].y());
        const osg::Vec3d normal(answers[i].x(), answers[i].y(), answers[i].z());
        heights.push_back(std::abs(answers[i].w() - waves.getHeight(place, time)) / reach);
        const osg::Vec3d expected = waves.getNormal(place, time);
        angles.push_back(std::atan2((normal ^ expected).length(), normal * expected) * 180.0 / PI);
    }
    const auto percentile = [](std::vector<double>& values)
    {
        for (double& value : values)
            if (!std::isfinite(value)) value = 1e9;
        const std::size_t rank = values.size() * 999 / 1000;
        std::nth_element(values.begin(), values.begin() + rank, values.end());
        return values[rank];
    };
    return {percentile(heights), percentile(angles)};
}

} // namespace

// Falls when restPlace starts from p without a step (waveNewtonSteps 0), loses its bound of the
// reach (at 0.99), or newtonSteps gives one step less.
TEST_CASE("the shader's waves are the CPU's, within 1 % of height and half a degree of normal")
{
    for (double steepness : {0.1, 0.25, 0.4, 0.6, 0.75, 0.9, 0.97, 0.99, 0.9999})
        for (const System& system : systems(steepness))
        {
            REQUIRE(system.waves);
            const Errors errors = measure(*system.waves, 0, osg::Vec2d(12.0, -7.0), 5.0);
            INFO(system.name << ", steepness " << steepness);
            CHECK(errors.height < 0.01);
            CHECK(errors.degrees < 0.5);
        }
}

// Falls when apply takes the phase at (0, 0) instead of at the anchor.
TEST_CASE("far from the origin and very late, the shader's waves are as exact as here and now")
{
    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(4.0, 0.2);
    const Errors here = measure(*waves, 0, osg::Vec2d(), 0.0);
    const Errors there = measure(*waves, 0, osg::Vec2d(6.4e6, -6.4e6), 1e7);
    CHECK(there.height < 1.5 * here.height);
    CHECK(there.degrees < 1.5 * here.degrees);

    // A kilometre from the anchor the phase of the shortest wave, 12,000 radians, is rounded to
    // 0.001: nothing beside what Newton's steps leave.
    const Errors kilometre = measure(*waves, 0, osg::Vec2d(), 0.0, 1000.0);
    CHECK(kilometre.height < 0.01);
    CHECK(kilometre.degrees < 0.5);
}

// Falls when waveSlope divides by a determinant that has become 0, and when setWaves takes lengths
// that single precision cannot hold.
TEST_CASE("waves at their limits have unit normals and finite heights everywhere")
{
    ShaderProbe& probe = waveProbe();
    std::mt19937 random(12);
    const auto uniform = [&](double low, double high)
    { return std::uniform_real_distribution<double>(low, high)(random); };
    const auto anyLength = [&] { return std::pow(10.0, uniform(-6.0, 9.0)); };
    for (int i = 0; i < 60; ++i)
    {
        const double steepnesses[] = {1.0 - 1e-12, 1.0 - 1e-7, 0.9999, 0.5, 1e-9};
        const double steepness = steepnesses[i % 5];
        std::vector<TrochoidalWave> list;
        for (int waves = 1 + i % 7 * 5; waves > 0; --waves)
            list.push_back(steepWave(steepness, anyLength(), uniform(-720.0, 720.0)));
        for (TrochoidalWave& wave : list)
            wave.amplitude /= list.size() * (1.0 + 1e-15);
        const osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
        if (!waves->setWaves(list)) continue; // rounded up to 1
        const double time = i % 3 ? std::pow(10.0, uniform(0.0, 9.0)) : 0.0;
        waves->createState(time)->apply(probe.stateSet(),
                                        osg::Vec2d(uniform(-1e7, 1e7), uniform(-1e7, 1e7)));

        // About the length of one of them, for it is there that crests are met, and anywhere.
        const double reach = i % 2 ? 2.0 * list.front().length : anyLength();
        std::vector<osg::Vec4> places, pixels;
        for (int j = 0; j < 20000; ++j)
        {
            places.push_back(osg::Vec4(uniform(-reach, reach), uniform(-reach, reach), 0, 0));
            const double side = j % 2 ? 0.0 : std::pow(10.0, uniform(-9.0, 9.0));
            pixels.push_back(osg::Vec4(side, 0, 0, side));
        }
        const std::vector<osg::Vec4> answers = probe.run(places, pixels);
        int wrong = 0;
        for (const osg::Vec4& answer : answers)
            wrong +=
                !(std::abs(osg::Vec3d(answer.x(), answer.y(), answer.z()).length() - 1.0) < 1e-4) ||
                !std::isfinite(answer.w());
        INFO(i << ": " << list.size() << " waves, the first of " << list.front().length
               << " m, steepness " << steepness << ", reach " << reach);
        CHECK(wrong == 0);
    }
}

TEST_CASE("print the table of the shader's errors, for docs/waves.md", "[.table]")
{
    std::printf("| steepness | waves |");
    for (int steps = 1; steps <= 6; ++steps)
        std::printf(" %d |", steps);
    std::printf("\n|---|---|---|---|---|---|---|---|\n");
    for (double steepness : {0.1, 0.25, 0.4, 0.6, 0.75, 0.9, 0.99})
        for (const System& system : systems(steepness))
        {
            std::printf("| %g | %s |", steepness, system.name);
            for (int steps = 1; steps <= 6; ++steps)
            {
                const Errors errors = measure(*system.waves, steps, osg::Vec2d(12.0, -7.0), 5.0);
                std::printf(" %.2g %%, %.2g° |", 100.0 * errors.height, errors.degrees);
            }
            std::printf("\n");
        }
}

// Falls when pixelAverage's factor is another than -0.125.
TEST_CASE("the normal is the average over a Gaussian pixel, half a pixel wide")
{
    // One wave of small amplitude: a sine. Its slope is averaged here by quadrature over
    // footprints of any shape; the shader has the closed form.
    const double length = 2.0;
    const double k = 2.0 * PI / length;
    const double steepness = 1e-3;
    osg::ref_ptr<TrochoidalWaves> waves = wavesOf({steepWave(steepness, length, 0.0)});
    ShaderProbe& probe = waveProbe();
    waves->createState(0.0)->apply(probe.stateSet(), osg::Vec2d());

    std::mt19937 random(12);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    std::vector<osg::Vec4> places;
    std::vector<osg::Vec4> footprints;
    for (int i = 0; i < 300; ++i)
    {
        places.push_back(osg::Vec4(anywhere(random), anywhere(random), 0, 0));
        const double size = std::pow(10.0, anywhere(random));
        footprints.push_back(osg::Vec4(size * anywhere(random), size * anywhere(random),
                                       size * anywhere(random), size * anywhere(random)));
    }
    const std::vector<osg::Vec4> answers = probe.run(places, footprints);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        double sum = 0.0;
        double weights = 0.0;
        const double step = 0.0625; // [pixels]; standard deviation 0.5, summed over 6 of them
        for (double u = -3.0; u <= 3.0; u += step)
            for (double v = -3.0; v <= 3.0; v += step)
            {
                const double weight = std::exp(-0.5 * (u * u + v * v) / 0.25);
                const double x = places[i].x() + u * footprints[i].x() + v * footprints[i].z();
                sum += weight * -steepness * std::sin(k * x);
                weights += weight;
            }
        const double slope = -answers[i].x() / answers[i].z();
        // The trochoid's own sharpening is of the order of the steepness squared; a wave of many
        // turns within the quadrature's step is not resolved, but has averaged away.
        REQUIRE(slope == Approx(sum / weights).margin(5e-3 * steepness));
        REQUIRE(answers[i].y() == Approx(0.0).margin(1e-6));
    }
}

// By the law of total variance: what is seen of the slopes in the pixels' means, and what is
// averaged away in each, are all of them. Falls when the covariance has left instead of left *
// left, or leaves out the half.
TEST_CASE("the means of pixels and what they average away have the covariance of all slopes")
{
    const osg::ref_ptr<TrochoidalWaves> waves = wavesOf(
        {steepWave(0.01, 2.0, 25.0), steepWave(0.02, 0.7, 70.0), steepWave(0.01, 0.2, -30.0)});
    const osg::Vec3d expected = waves->getSlopeCovariance(std::numeric_limits<double>::infinity());
    const std::string body = "#include \"waves.glsl\"\n"
                             "vec4 probe(vec4 first, vec4 second)\n"
                             "{\n"
                             "    WaveSlope slope = waveSlope(first.xy, second.xy, second.zw);\n";
    ShaderProbe mean(body + "    return vec4(slope.mean, 0.0, 0.0);\n}\n", waveSlot(*waves));
    ShaderProbe averaged(body + "    return vec4(slope.covariance, 0.0);\n}\n", waveSlot(*waves));
    for (ShaderProbe* probe : {&mean, &averaged})
        waves->createState(0.0)->apply(probe->stateSet(), osg::Vec2d());

    std::mt19937 random(13);
    std::uniform_real_distribution<float> anywhere(-300.0f, 300.0f);
    for (const float size : {0.0f, 0.1f, 0.4f, 1.0f, 50.0f})
    {
        INFO("a pixel of " << size << " m");
        const osg::Vec4 pixel(size, 0.2f * size, -0.3f * size, 2.0f * size);
        std::vector<osg::Vec4> places;
        for (int i = 0; i < 60000; ++i)
            places.push_back(osg::Vec4(anywhere(random), anywhere(random), 0, 0));
        const std::vector<osg::Vec4> pixels(places.size(), pixel);
        const std::vector<osg::Vec4> means = mean.run(places, pixels);
        osg::Vec3d sum;
        for (const osg::Vec4& slope : means)
            sum += osg::Vec3d(slope.x() * slope.x(), slope.y() * slope.y(), slope.x() * slope.y());
        sum /= static_cast<double>(places.size());
        const osg::Vec4 away = averaged.run({places[0]}, {pixel})[0];
        sum += osg::Vec3d(away.x(), away.y(), away.z());
        if (size == 0.0f) CHECK(osg::Vec3d(away.x(), away.y(), away.z()).length() == 0.0);
        // The mean of 60,000 squared sines errs by 0.3 %; the trochoids' own sharpening is of the
        // order of the steepness.
        const double tolerance = 0.02 * (expected.x() + expected.y());
        CHECK(std::abs(sum.x() - expected.x()) < tolerance);
        CHECK(std::abs(sum.y() - expected.y()) < tolerance);
        CHECK(std::abs(sum.z() - expected.z()) < tolerance);
    }
}

// Falls when waves_calm.glsl returns another height than 0.
TEST_CASE("the calm piece is flat")
{
    ShaderProbe probe(NORMAL_AND_HEIGHT);
    for (const osg::Vec4& answer : probe.run({osg::Vec4(1, 2, 0, 0), osg::Vec4(-1e6, 3, 0, 0)}))
        CHECK(answer == osg::Vec4(0, 0, 1, 0));
}

namespace
{

// A plain grey sky over a dark horizon: a gradient that shows every change of a normal.
osg::ref_ptr<osg::TextureCubeMap> gradientSky()
{
    const int side = 64;
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(side, side, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        for (int t = 0; t < side; ++t)
            for (int s = 0; s < side; ++s)
            {
                const double a = 2.0 * (s + 0.5) / side - 1.0;
                const double b = 2.0 * (t + 0.5) / side - 1.0;
                // The z of the face's direction [OpenGL 4.6, table 8.19].
                const double up = face == osg::TextureCubeMap::POSITIVE_Z   ? 1.0
                                  : face == osg::TextureCubeMap::NEGATIVE_Z ? -1.0
                                  : face == osg::TextureCubeMap::POSITIVE_X ? -a
                                  : face == osg::TextureCubeMap::NEGATIVE_X ? a
                                                                            : b;
                const double upOfY = face == osg::TextureCubeMap::NEGATIVE_Y ? -b : up;
                const double z = upOfY / std::sqrt(a * a + b * b + 1.0);
                const auto grey = static_cast<unsigned char>(255.0 * std::max(z, 0.0));
                unsigned char* texel = image->data(s, t);
                texel[0] = texel[1] = texel[2] = grey;
                texel[3] = 255;
            }
        sky->setImage(face, image);
    }
    sky->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    sky->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    return sky;
}

// Mean difference of neighbouring pixels along a row.
double roughness(const osg::Image& image, int row)
{
    double sum = 0.0;
    for (int x = 1; x < image.s(); ++x)
        sum += std::abs(pixel(image, x, row).r() - pixel(image, x - 1, row).r());
    return sum / (image.s() - 1);
}

} // namespace

// Falls when pixelAverage returns 1: the far rows are then as rough as noise.
TEST_CASE("far water is smooth, and does not flicker")
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<WaterSurface> water = scenes::inView(
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(2000, 0, 0), osg::Vec3(0, 2000, 0)));
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(1.0, 0.15, 60.0);
    water->setWaves(waves);
    water->setSky(gradientSky());
    water->setDebugView(WaterSurface::DebugView::REFLECTION);
    root->addChild(water);

    OffscreenView view(320, 240);
    view.look(osg::Vec3d(0, 0, 3), osg::Vec3d(0, 20, 0), 46.0);
    osg::ref_ptr<osg::Image> first = copyOf(view.render(root, 10.0));
    keep(*first, "waves-far");
    const osg::Image& second = view.render(root, 10.1);

    // Where a row of pixels lies on the water: pitch and the row's angle.
    const auto rowAt = [](double distance)
    {
        const double pitch = std::atan2(3.0, 20.0);
        const double tangent = std::tan(pitch - std::atan2(3.0, distance));
        return static_cast<int>(120.0 + 120.0 * tangent / std::tan(23.0 * PI / 180.0));
    };
    // At 600 m a pixel is 5 m wide and hundreds long: not one of the waves, all below 1 m, is
    // left. The reflection is the calm sky's, level along the row, and stays as it is.
    const int far = rowAt(600.0);
    INFO("rows " << far << " and " << rowAt(6.0));
    CHECK(roughness(*first, far) < 0.5 / 255.0);
    double change = 0.0;
    for (int x = 0; x < 320; ++x)
        change = std::max<double>(change,
                                  std::abs(pixel(*first, x, far).r() - pixel(second, x, far).r()));
    CHECK(change <= 1.0 / 255.0);
    // Close by they are all there.
    CHECK(roughness(*first, rowAt(6.0)) > 2.0 / 255.0);
}
