// The sky as OpenGL looks it up.

#include "support/Catch.h"

#include <osgwaterbench/measures/SkyLookup.h>

#include <glm/geometric.hpp>

using osgwaterbench::SkyLookup;

namespace
{

// Colours that tell face, column and row: (face, s, t) / 10.
osg::ref_ptr<osg::TextureCubeMap> createSky(int side)
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(side, side, 1, GL_RGB, GL_FLOAT);
        for (int t = 0; t < side; ++t)
            for (int s = 0; s < side; ++s)
                image->setColor(osg::Vec4(face / 10.0f, s / 10.0f, t / 10.0f, 1.0f),
                                static_cast<unsigned int>(s), static_cast<unsigned int>(t));
        sky->setImage(face, image);
    }
    return sky;
}

// Table 8.19 of OpenGL 4.6, as directions: where a face looks, and where its s and t run.
const struct
{
    glm::dvec3 major, s, t;
} FACES[] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
};

bool near(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::distance(a, b) < 1e-6; // texels are in single precision
}

} // namespace

// Falls when t of the -y face is turned round.
TEST_CASE("sky: faces and places on them are OpenGL's")
{
    const int side = 4;
    const SkyLookup sky(*createSky(side));
    for (int face = 0; face < 6; ++face)
        for (int t = 0; t < side; ++t)
            for (int s = 0; s < side; ++s)
            {
                const double u = (s + 0.5) / side * 2.0 - 1.0; // a texel's centre
                const double v = (t + 0.5) / side * 2.0 - 1.0;
                const glm::dvec3 dir = FACES[face].major + u * FACES[face].s + v * FACES[face].t;
                INFO("face " << face << ", " << s << ", " << t);
                CHECK(near(sky.colour(dir), glm::dvec3(face, s, t) / 10.0));
                CHECK(near(sky.colour(7.0 * dir), glm::dvec3(face, s, t) / 10.0));
            }
}

// Falls when texel centres are taken to lie at whole numbers, and when texels are not mixed.
TEST_CASE("sky: texels are mixed within a face, its outermost reach up to its edge")
{
    const int side = 4;
    const SkyLookup sky(*createSky(side));
    const auto at = [&](double u, double v) { return sky.colour(glm::dvec3(1.0, -v, -u)); };
    CHECK(near(at(0.0, 0.0), glm::dvec3(0, 1.5, 1.5) / 10.0));
    CHECK(near(at(0.125, -0.25), glm::dvec3(0, 1.75, 1.0) / 10.0));
    CHECK(near(at(-0.99, 0.99), glm::dvec3(0, 0, 3) / 10.0));
    CHECK(near(at(0.8, -0.9), glm::dvec3(0, 3, 0) / 10.0));
    CHECK(near(at(-1.0, 0.0), glm::dvec3(0, 0, 1.5) / 10.0));
}

TEST_CASE("sky: one colour, and a face that is missing")
{
    const SkyLookup plain(glm::dvec3(0.1, 0.2, 0.3));
    CHECK(near(plain.colour(glm::dvec3(-1, 2, 3)), glm::dvec3(0.1, 0.2, 0.3)));
    const osg::ref_ptr<osg::TextureCubeMap> sky = createSky(2);
    sky->setImage(osg::TextureCubeMap::POSITIVE_Z, nullptr);
    CHECK(near(SkyLookup(*sky).colour(glm::dvec3(0, 0, 1)), glm::dvec3(0.0)));
    CHECK(near(SkyLookup(*sky).colour(glm::dvec3(0, 0, -1)), glm::dvec3(0.5, 0.05, 0.05)));
}
