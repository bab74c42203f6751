// The scenes and waters of which there are ever more.

#include "Mesh.h"
#include "SceneFiles.h"

#include <osgWaterReflect/Check.h>

#include <cmath>
#include <iterator>

using namespace osgwaterbench;
using osgWaterReflect::refuse;
using osgWaterReflect::WaterSurface;

namespace
{

const std::size_t FEWEST_TRIANGLES = 1000;
const std::size_t MOST_TRIANGLES = 10000000;

const osg::Vec3d EYE(0.0, 0.0, 2.2);     // [m]
const osg::Vec3d CENTRE(0.0, 30.0, 2.6); // [m]
const double FOVY_DEGREES = 46.0;

// The water [m], twice as wide as the picture is at the hills' feet. It begins before the picture's
// lowest rays meet it, and ends below the hills.
const float LEFT = -70.0f;
const float RIGHT = 70.0f;
const float NEAR_EDGE = 4.0f;
const float FAR_EDGE = 70.0f;

const int MOST_WATERS = 64;
const float NOTCH = 1.0f; // [m] to each side of the far edge, which the hills hide for 9 m

// The hills: a strip of squares, of two triangles each, that rises from the far shore.
struct HillRow
{
    double y;      // [m]
    double height; // [m] of z on average
    double relief; // [1] of the height, to each side
    osg::Vec3 colour;
};

const HillRow HILL_ROWS[] = {
    {56.0, -1.5, 0.0, {0.42f, 0.38f, 0.28f}},  {61.0, 0.35, 0.2, {0.55f, 0.52f, 0.36f}},
    {74.0, 3.0, 0.5, {0.42f, 0.52f, 0.24f}},   {94.0, 8.0, 0.6, {0.30f, 0.44f, 0.22f}},
    {122.0, 14.0, 0.5, {0.30f, 0.42f, 0.30f}}, {160.0, 20.0, 0.45, {0.42f, 0.52f, 0.50f}}};
const std::size_t HILL_STRIPS = std::size(HILL_ROWS) - 1;
const int HILL_COLUMNS = 40;
const int HILL_COLUMNS_A_CHUNK = 4;
const double HILLS_WIDTH = 320.0; // [m]

const std::size_t TOWERS = 48;
const double FOUNDATION = 1.5; // [m] below the water and the hills

// Triangles when nothing is divided.
const std::size_t HILL_TRIANGLES = 2 * HILL_STRIPS * HILL_COLUMNS;
const std::size_t TOWER_TRIANGLES = 12;
const std::size_t COARSEST = HILL_TRIANGLES + TOWERS * TOWER_TRIANGLES;
static_assert(COARSEST <= FEWEST_TRIANGLES);

// In [0, 1), spread evenly and without a pattern: the share of a turn that never falls into step.
double spread(std::size_t index, double turn)
{
    const double turned = (index + 1) * turn;
    return turned - std::floor(turned);
}

Mesh::Corner hillCorner(int column, std::size_t row)
{
    const HillRow& hill = HILL_ROWS[row];
    const double x = HILLS_WIDTH * (static_cast<double>(column) / HILL_COLUMNS - 0.5);
    // Sines of lengths that have no common multiple: [-1, 1].
    const double waviness =
        0.6 * std::sin(0.061 * x + 1.9 * row) + 0.4 * std::sin(0.173 * x + 4.1 * row);
    const double light = 0.85 + 0.15 * std::sin(2.4 * column + 1.7 * row);
    return {osg::Vec3d(x, hill.y, hill.height * (1.0 + hill.relief * waviness)),
            hill.colour * static_cast<float>(light)};
}

// Every edge in `parts`.
osg::ref_ptr<osg::Geode> createHills(unsigned int parts)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("hills");
    Mesh mesh;
    for (int column = 0; column < HILL_COLUMNS; ++column)
    {
        for (std::size_t row = 0; row < HILL_STRIPS; ++row)
        {
            const Mesh::Corner a = hillCorner(column, row), b = hillCorner(column + 1, row);
            const Mesh::Corner c = hillCorner(column + 1, row + 1), d = hillCorner(column, row + 1);
            mesh.addTriangle({a, b, c}, parts);
            mesh.addTriangle({a, c, d}, parts);
        }
        if ((column + 1) % HILL_COLUMNS_A_CHUNK == 0) geode->addDrawable(mesh.takeGeometry());
    }
    return geode;
}

// Towers stand in the lake and on its shore, the higher the farther, so that all end in the
// picture and in its mirror image.
Mesh createTower(std::size_t index, unsigned int columns, unsigned int rows)
{
    const double away = 14.0 + 66.0 * spread(index, 0.6180339887);         // [m]
    const double aside = 1.2 * away * (spread(index, 0.7548776662) - 0.5); // [m]
    const double side = 1.0 + 0.05 * away * spread(index, 0.5698402910);   // [m]
    const double height = 1.0 + 0.12 * away * spread(index, 0.3247179572); // [m]
    const double ground = away < 60.0 ? 0.0 : 0.1 * (away - 60.0);         // [m] at most the hills'
    const osg::Vec3 colour(0.35 + 0.6 * spread(index, 0.8191725134),
                           0.35 + 0.6 * spread(index, 0.6710436067), 0.5);
    Mesh mesh;
    mesh.addBox(osg::Vec3d(aside, away, ground - FOUNDATION),
                osg::Vec3d(aside + side, away + side, ground + height), colour, columns, rows);
    return mesh;
}

// Squares on the towers are divided alike; what is missing then are rows of the sides.
osg::ref_ptr<osg::Geode> createTowers(unsigned int parts, std::size_t missing)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("towers");
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, createChequers());
    const std::size_t trianglesARow = 8 * parts;
    const std::size_t rows = (missing + trianglesARow / 2) / trianglesARow;
    for (std::size_t i = 0; i < TOWERS; ++i)
    {
        const unsigned int more = rows / TOWERS + (i < rows % TOWERS ? 1 : 0);
        geode->addDrawable(createTower(i, parts, parts + more).takeGeometry());
    }
    return geode;
}

// The strip of the scaling scene's water between two distances.
osg::ref_ptr<WaterSurface> createStrip(float nearest, float farthest)
{
    return WaterSurface::createPolygon({osg::Vec3(LEFT, nearest, 0), osg::Vec3(RIGHT, nearest, 0),
                                        osg::Vec3(RIGHT, farthest, 0),
                                        osg::Vec3(LEFT, farthest, 0)});
}

} // namespace

osg::ref_ptr<osg::Group> osgwaterbench::createComplexScene(std::size_t triangles)
{
    if (triangles < FEWEST_TRIANGLES || triangles > MOST_TRIANGLES)
    {
        refuse("createComplexScene", "a number of triangles in [1e3, 1e7]", triangles);
        return nullptr;
    }
    // The floor of the root; rounding would have to be off by 1e-16 to matter.
    const unsigned int parts = std::sqrt(static_cast<double>(triangles) / COARSEST);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    scene->addChild(createHills(parts));
    scene->addChild(createTowers(parts, triangles - COARSEST * parts * parts));
    return scene;
}

BenchScene osgwaterbench::createScalingScene(std::size_t triangles)
{
    BenchScene bench;
    bench.name = "scaling";
    const osg::ref_ptr<osg::Group> land = createComplexScene(triangles);
    const std::vector<osg::ref_ptr<WaterSurface>> waters = createWaters(1);
    if (!land || waters.empty()) return bench;
    bench.scene = createUnderSky();
    if (bench.scene) bench.scene->addChild(land);
    bench.water = waters.front();
    bench.eye = EYE;
    bench.centre = CENTRE;
    bench.fovyDegrees = FOVY_DEGREES;
    return bench;
}

std::vector<osg::ref_ptr<WaterSurface>> osgwaterbench::createWaters(int count)
{
    if (count < 1 || count > MOST_WATERS)
    {
        refuse("createWaters", "a number of waters in [1, 64]", count);
        return {};
    }
    const osg::ref_ptr<osg::TextureCubeMap> sky = readDemoSky();
    if (!sky) return {};
    // The same expression on both sides of a seam, so that neighbours share their corners.
    const auto seam = [&](int i)
    { return NEAR_EDGE + (FAR_EDGE - NEAR_EDGE) * static_cast<float>(i) / count; };
    std::vector<osg::ref_ptr<WaterSurface>> waters;
    for (int i = 0; i < count; ++i)
    {
        waters.push_back(createStrip(seam(i), seam(i + 1)));
        waters.back()->setSky(sky);
    }
    return waters;
}

osg::ref_ptr<WaterSurface> osgwaterbench::createShapedWater(int corners)
{
    if (corners < 4)
    {
        refuse("createShapedWater", "at least 4 corners", corners);
        return nullptr;
    }
    const osg::ref_ptr<osg::TextureCubeMap> sky = readDemoSky();
    if (!sky) return nullptr;
    WaterSurface::Outline outline = {osg::Vec3(LEFT, NEAR_EDGE, 0), osg::Vec3(RIGHT, NEAR_EDGE, 0)};
    // From notch to notch the mean is the straight edge, so that the area is the rectangle's.
    const int onFarEdge = corners - 2;
    for (int i = 0; i < onFarEdge; ++i)
    {
        const float x = RIGHT + (LEFT - RIGHT) * static_cast<float>(i) / (onFarEdge - 1);
        const float notch = corners == 4 ? 0.0f : i % 2 == 0 ? NOTCH : -NOTCH;
        outline.push_back(osg::Vec3(x, FAR_EDGE + notch, 0));
    }
    const osg::ref_ptr<WaterSurface> water = WaterSurface::createPolygon(outline);
    water->setSky(sky);
    return water;
}
