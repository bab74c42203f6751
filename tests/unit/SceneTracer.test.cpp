// Rays against scenes whose answers are known in closed form.

#include "support/Catch.h"
#include "support/Scenes.h"

#include <osgWaterReflect/reference/SceneTracer.h>

#include <osg/Billboard>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osg/Switch>

#include <cmath>
#include <limits>
#include <random>

using namespace osgWaterReflect::reference;

namespace
{

const osg::Vec3d DOWN(0, 0, -1);

// A few roundings of double precision at places of the size of 10: what closed forms allow.
const double EXACT = 1e-13;

// The triangle (0, 0), (1, 0), (0, 1) at a height, with an array of colours.
osg::ref_ptr<osg::Geometry> createTriangle(osg::Array* colours = nullptr, float z = 0.0f)
{
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    corners->push_back(osg::Vec3(0, 0, z));
    corners->push_back(osg::Vec3(1, 0, z));
    corners->push_back(osg::Vec3(0, 1, z));
    triangle->setVertexArray(corners);
    if (colours) triangle->setColorArray(colours);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    return triangle;
}

// The square from (0, 0) to (1, 1) at z = 0 with a picture of 2 x 2 texels: red and green below,
// blue and white above. It takes its texture coordinates from 0 to `repeats`.
osg::ref_ptr<osg::Node> createPictureQuad(osg::Texture::FilterMode filter,
                                          osg::Texture::WrapMode wrap, float repeats = 1.0f)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    image->setColor(osg::Vec4(1, 0, 0, 1), 0, 0);
    image->setColor(osg::Vec4(0, 1, 0, 1), 1, 0);
    image->setColor(osg::Vec4(0, 0, 1, 1), 0, 1);
    image->setColor(osg::Vec4(1, 1, 1, 1), 1, 1);
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setBorderColor(osg::Vec4d(0.5, 0.25, 0.125, 1));
    osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(
        osg::Vec3(), osg::Vec3(1, 0, 0), osg::Vec3(0, 1, 0), repeats, repeats);
    quad->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return quad;
}

// A ball of unit radius about the origin: rows of quads between circles of latitude, closed by
// fans; corners are shared, so that it is watertight.
osg::ref_ptr<osg::Geometry> createBall(int rows, int columns)
{
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    const osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    corners->push_back(osg::Vec3(0, 0, -1));
    for (int row = 1; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const double latitude = osg::PI * row / rows - osg::PI_2;
            const double longitude = 2.0 * osg::PI * column / columns;
            corners->push_back(osg::Vec3d(std::cos(latitude) * std::cos(longitude),
                                          std::cos(latitude) * std::sin(longitude),
                                          std::sin(latitude)));
        }
    corners->push_back(osg::Vec3(0, 0, 1));
    const unsigned int last = corners->size() - 1;
    const auto corner = [&](int row, int column) -> unsigned int {
        return row == 0 ? 0 : row == rows ? last : 1 + (row - 1) * columns + column % columns;
    };
    const auto add = [&](unsigned int a, unsigned int b, unsigned int c)
    {
        if (a == b || b == c || c == a) return;
        for (unsigned int index : {a, b, c})
            triangles->push_back(index);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            add(corner(row, column), corner(row, column + 1), corner(row + 1, column + 1));
            add(corner(row, column), corner(row + 1, column + 1), corner(row + 1, column));
        }
    osg::ref_ptr<osg::Geometry> ball = new osg::Geometry;
    ball->setVertexArray(corners);
    ball->addPrimitiveSet(triangles);
    return ball;
}

osg::Vec3d randomDir(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    osg::Vec3d dir(normal(random), normal(random), normal(random));
    dir.normalize();
    return dir;
}

double distance(const osg::Vec3d& a, const osg::Vec3d& b)
{
    return (a - b).length();
}

bool sameColour(const osg::Vec4& a, const osg::Vec4& b)
{
    return (a - b).length() < 1e-6; // roundings of single precision
}

// The colour straight below a place; black and transparent where nothing is.
osg::Vec4 colourBelow(const SceneTracer& tracer, double x, double y)
{
    const std::optional<SceneHit> hit = tracer.trace(osg::Vec3d(x, y, 10), DOWN);
    return hit ? hit->colour : osg::Vec4();
}

} // namespace

// Falls when meetingAt() rounds t to single precision, and when refine() returns what single
// precision says (`sharesOf(u, v)`).
TEST_CASE("a plane is met where its equation says")
{
    // Through the z axis at 1, rising by 1 / 2 along x and falling by 1 / 4 along y.
    const osg::ref_ptr<osg::Node> plane =
        scenes::createQuad(osg::Vec3(-4, -4, 0), osg::Vec3(8, 0, 4), osg::Vec3(0, 8, -2),
                           osg::Vec4(0.25, 0.5, 0.75, 1));
    const SceneTracer tracer(*plane);
    CHECK(tracer.triangleCount() == 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(-3.9, 3.9);
    for (int i = 0; i < 1000; ++i)
    {
        const double x = inside(random);
        const double y = inside(random);
        const osg::Vec3d expected(x, y, 1.0 + 0.5 * x - 0.25 * y);
        const osg::Vec3d origin(inside(random), inside(random), 7.0);
        const std::optional<SceneHit> hit = tracer.trace(origin, (expected - origin) * 3.0);
        REQUIRE(hit);
        // The plane's height over the ray is told to a rounding, and the ray meets it at more than
        // 10 degrees.
        CHECK(distance(hit->point, expected) < 10 * EXACT);
        CHECK(std::abs(hit->t - distance(origin, expected)) < 10 * EXACT);
        CHECK(distance(hit->normal, osg::Vec3d(-2, 1, 4) / std::sqrt(21.0)) < EXACT);
        CHECK(sameColour(hit->colour, osg::Vec4(0.25, 0.5, 0.75, 1)));
        CHECK(hit->writesDepth);
    }
    CHECK_FALSE(tracer.trace(osg::Vec3d(0, 0, 7), osg::Vec3d(0, 0, 1)));
    CHECK_FALSE(tracer.trace(osg::Vec3d(5, 0, 7), DOWN));
}

// Falls when apply(osg::Transform) does not put the outer matrix back.
TEST_CASE("a box is met through the transforms above it")
{
    const osg::ref_ptr<osg::MatrixTransform> outer = new osg::MatrixTransform(
        osg::Matrixd::rotate(0.7, osg::Vec3d(1, 2, -1)) * osg::Matrixd::translate(3, -1, 2));
    const osg::ref_ptr<osg::MatrixTransform> inner =
        new osg::MatrixTransform(osg::Matrixd::scale(2, 0.5, 3));
    const osg::ref_ptr<osg::Geode> empty = new osg::Geode;
    const osg::ref_ptr<osg::MatrixTransform> sibling =
        new osg::MatrixTransform(osg::Matrixd::translate(100, 0, 0));
    sibling->addChild(empty);
    outer->addChild(sibling);
    outer->addChild(inner);
    inner->addChild(scenes::createBox(osg::Vec3(), osg::Vec3(2, 2, 2), osg::Vec4(1, 1, 1, 1)));
    const SceneTracer tracer(*outer);

    // In the outer transform's space the box reaches to 2, 0.5 and 3: the slabs of its sides say
    // where a ray enters.
    const osg::Vec3d half(2, 0.5, 3);
    const osg::Matrixd outerFromWorld = osg::Matrixd::inverse(outer->getMatrix());
    std::mt19937 random(4);
    int hits = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const osg::Vec3d origin = osg::Vec3d(3, -1, 2) + randomDir(random) * 8.0;
        osg::Vec3d dir = osg::Vec3d(3, -1, 2) + randomDir(random) * 2.0 - origin;
        dir.normalize();
        const osg::Vec3d originLocal = origin * outerFromWorld;
        const osg::Vec3d dirLocal = osg::Matrixd::transform3x3(dir, outerFromWorld);
        double enter = 0.0;
        double leave = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis)
        {
            const double a = (-half[axis] - originLocal[axis]) / dirLocal[axis];
            const double b = (half[axis] - originLocal[axis]) / dirLocal[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        // Closer to an edge than single precision tells, either is right.
        if (std::abs(leave - enter) < 1e-4) continue;
        const std::optional<SceneHit> hit = tracer.trace(origin, dir);
        REQUIRE(hit.has_value() == (enter < leave));
        if (!hit) continue;
        ++hits;
        // Next to an edge the side beyond it may be met instead, drawn back onto its triangle: by
        // no more than a hundred roundings of single precision at the size of the box.
        CHECK(std::abs(hit->t - enter) < 1e-5);
        const std::optional<SceneHit> far = tracer.trace(origin, dir, 0.5 * (enter + leave));
        REQUIRE(far);
        CHECK(std::abs(far->t - leave) < 1e-5);
    }
    CHECK(hits > 3000);
}

// A chord's triangle lies inside the sphere by no more than its sagitta, 1 - cos of the angle from
// its middle to its farthest corner. Falls when trace() does not move the ray's start to the scene
// (`start = nearest - slack`): from 1e6 away single precision misses the ball by its own size.
TEST_CASE("a ball of many triangles is met within its sagitta")
{
    const int rows = 90;
    const osg::ref_ptr<osg::Geometry> ball = createBall(rows, 2 * rows);
    const SceneTracer tracer(*ball);
    // Half a cell's diagonal.
    const double sagitta = 1.0 - std::cos(osg::PI / rows * std::sqrt(0.5));
    std::mt19937 random(5);
    for (double far : {3.0, 1e6})
        for (int i = 0; i < 5000; ++i)
        {
            const osg::Vec3d outside = randomDir(random);
            const std::optional<SceneHit> hit = tracer.trace(outside * far, -outside);
            REQUIRE(hit);
            // Toward the centre, so that the distance is the radius there. Roundings: of single
            // precision in the corners, and of double at 1e6.
            CHECK(hit->t >= far - 1.0 - 1e-6);
            CHECK(hit->t <= far - 1.0 + sagitta + 1e-6);
            CHECK(hit->normal * outside > 0.99);
        }
}

// Falls without RTC_SCENE_FLAG_ROBUST, and without trace()'s second ray beside the first.
TEST_CASE("no ray slips between the triangles of a closed surface")
{
    const osg::ref_ptr<osg::Geometry> ball = createBall(60, 120);
    const SceneTracer tracer(*ball);
    const auto& corners = static_cast<const osg::Vec3Array&>(*ball->getVertexArray());
    std::mt19937 random(6);
    int outOfBall = 0;
    int intoEdges = 0;
    const int rays = 100000;
    for (int i = 0; i < rays; ++i)
    {
        const osg::Vec3d inside = randomDir(random) * 0.9;
        outOfBall += tracer.trace(inside, randomDir(random)).has_value();
        // At the edges themselves, and at corners: a row's neighbours.
        const std::size_t first = 1 + i % (corners.size() - 3);
        const double share = (i % 97) / 97.0;
        const osg::Vec3d onEdge =
            osg::Vec3d(corners[first]) * share + osg::Vec3d(corners[first + 1]) * (1.0 - share);
        intoEdges += tracer.trace(inside, onEdge - inside).has_value();
    }
    CHECK(outOfBall == rays);
    CHECK(intoEdges == rays);
}

// Falls when build() does not set the centre, and when add() rounds the corners in the world to
// single precision.
TEST_CASE("a scene as far out as the Earth's surface is met as exactly as it is placed")
{
    const osg::Vec3d place(6.4e6 + 0.3, -2.1e6 + 0.1, 1.3e6 + 0.7);
    const osg::ref_ptr<osg::MatrixTransform> far =
        new osg::MatrixTransform(osg::Matrixd::translate(place));
    far->addChild(scenes::createBox(osg::Vec3(), osg::Vec3(2, 2, 2), osg::Vec4(1, 1, 1, 1)));
    const SceneTracer tracer(*far);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(-0.99, 0.99);
    for (int i = 0; i < 1000; ++i)
    {
        const osg::Vec3d expected = place + osg::Vec3d(inside(random), inside(random), 1.0);
        const osg::Vec3d origin = place + osg::Vec3d(inside(random), inside(random), 5.0);
        const std::optional<SceneHit> hit = tracer.trace(origin, expected - origin);
        REQUIRE(hit);
        // Double precision rounds such places by 5e-10, and a hit takes some tens of roundings.
        CHECK(distance(hit->point, expected) < 1e-8);
    }
}

// Falls when the traversal visits all children, and when apply(osg::Node) does not look for water.
TEST_CASE("what is not drawn is not met")
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const SceneTracer empty(*scene);
    CHECK(empty.triangleCount() == 0);
    CHECK_FALSE(empty.trace(osg::Vec3d(0, 0, 10), DOWN));
    CHECK_FALSE(empty.occluded(osg::Vec3d(0, 0, 10), osg::Vec3d()));

    const auto isMet = [](const osg::ref_ptr<osg::Node>& node)
    {
        const osg::ref_ptr<osg::Group> around = new osg::Group;
        around->addChild(node);
        return SceneTracer(*around).trace(osg::Vec3d(0.2, 0.2, 10), DOWN).has_value();
    };
    const osg::ref_ptr<osg::Geometry> triangle = createTriangle();
    CHECK(isMet(triangle));
    triangle->setNodeMask(0);
    CHECK_FALSE(isMet(triangle));
    triangle->setNodeMask(~0u);

    const osg::ref_ptr<osg::Switch> onOff = new osg::Switch;
    onOff->addChild(triangle, true);
    CHECK(isMet(onOff));
    onOff->setAllChildrenOff();
    CHECK_FALSE(isMet(onOff));

    const osg::ref_ptr<osg::LOD> levels = new osg::LOD;
    levels->addChild(triangle, 0.0f, 10.0f);
    CHECK(isMet(levels));
    levels->setRange(0, 10.0f, 1000.0f);
    CHECK_FALSE(isMet(levels));

    const osg::ref_ptr<osg::Billboard> billboard = new osg::Billboard;
    billboard->addDrawable(triangle);
    CHECK_FALSE(isMet(billboard));

    const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::RELATIVE_RF);
    camera->addChild(triangle);
    camera->setRenderOrder(osg::Camera::NESTED_RENDER);
    CHECK(isMet(camera));
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    CHECK_FALSE(isMet(camera));

    CHECK_FALSE(isMet(scenes::createLake()));
}

// Falls when enter() drops the outer state (`new osg::StateSet` without `*outer`).
TEST_CASE("what writes no depth is passed, or met and marked so")
{
    const osg::ref_ptr<osg::Geometry> lower = createTriangle();
    const osg::ref_ptr<osg::Geometry> upper = createTriangle(nullptr, 1.0f);
    const osg::ref_ptr<osg::Group> leaves = new osg::Group;
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    leaves->addChild(upper);
    scene->addChild(leaves);
    scene->addChild(lower);
    const auto height = [&](SceneTracer::Kept kept, bool writesDepth)
    {
        const std::optional<SceneHit> hit =
            SceneTracer(*scene, kept).trace(osg::Vec3d(0.2, 0.2, 10), DOWN);
        REQUIRE(hit);
        CHECK(hit->writesDepth == writesDepth);
        return hit->point.z();
    };
    const auto kept = SceneTracer::Kept::DEPTH_WRITERS;
    CHECK(height(kept, true) == 1.0);

    osg::StateSet* state = leaves->getOrCreateStateSet();
    const osg::ref_ptr<osg::Depth> noWriting = new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false);
    state->setAttributeAndModes(noWriting);
    CHECK(height(kept, true) == 0.0);
    CHECK(height(SceneTracer::Kept::ALL, false) == 1.0);

    // A drawable's own Depth wins, unless the group overrides it.
    upper->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth);
    CHECK(height(kept, true) == 1.0);
    state->setAttributeAndModes(noWriting, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    CHECK(height(kept, true) == 0.0);

    // Without the depth test nothing is written, either.
    leaves->setStateSet(nullptr);
    upper->getStateSet()->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    CHECK(height(kept, true) == 0.0);
}

// Falls when mixed() takes a share twice, and when bytes are not divided by 255.
TEST_CASE("vertex colours are interpolated")
{
    const osg::ref_ptr<osg::Vec4Array> floats = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
    floats->push_back(osg::Vec4(1, 0, 0, 1));
    floats->push_back(osg::Vec4(0, 1, 0, 1));
    floats->push_back(osg::Vec4(0, 0, 1, 0));
    const SceneTracer fromFloats(*createTriangle(floats));
    // The shares of the corners at (x, y) are 1 - x - y, x and y.
    CHECK(sameColour(colourBelow(fromFloats, 0.2, 0.3), osg::Vec4(0.5, 0.2, 0.3, 0.7)));

    const osg::ref_ptr<osg::Vec4ubArray> bytes = new osg::Vec4ubArray(osg::Array::BIND_PER_VERTEX);
    bytes->push_back(osg::Vec4ub(255, 0, 0, 255));
    bytes->push_back(osg::Vec4ub(0, 255, 0, 255));
    bytes->push_back(osg::Vec4ub(0, 0, 51, 255));
    const SceneTracer fromBytes(*createTriangle(bytes));
    CHECK(sameColour(colourBelow(fromBytes, 0.2, 0.3), osg::Vec4(0.5, 0.2, 0.06, 1)));

    const osg::ref_ptr<osg::Vec3Array> overall = new osg::Vec3Array(osg::Array::BIND_OVERALL);
    overall->push_back(osg::Vec3(0.1, 0.6, 0.9));
    CHECK(sameColour(colourBelow(SceneTracer(*createTriangle(overall)), 0.2, 0.3),
                     osg::Vec4(0.1, 0.6, 0.9, 1)));
    CHECK(sameColour(colourBelow(SceneTracer(*createTriangle()), 0.2, 0.3), osg::Vec4(1, 1, 1, 1)));
}

// Falls when texel() forgets that texel centres lie at halves, and when wrapped() mirrors about a
// texel's centre (`2 * size - twice`).
TEST_CASE("a picture of 2 x 2 texels is looked up as its filter and wrap modes say")
{
    const osg::Vec4 red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1), white(1, 1, 1, 1);
    const osg::Vec4 border(0.5, 0.25, 0.125, 1);
    const SceneTracer nearest(
        *createPictureQuad(osg::Texture::NEAREST, osg::Texture::CLAMP_TO_EDGE));
    CHECK(sameColour(colourBelow(nearest, 0.1, 0.1), red));
    CHECK(sameColour(colourBelow(nearest, 0.9, 0.4), green));
    CHECK(sameColour(colourBelow(nearest, 0.4, 0.6), blue));
    CHECK(sameColour(colourBelow(nearest, 0.6, 0.6), white));

    const SceneTracer bilinear(
        *createPictureQuad(osg::Texture::LINEAR, osg::Texture::CLAMP_TO_EDGE));
    CHECK(sameColour(colourBelow(bilinear, 0.1, 0.1), red));
    CHECK(sameColour(colourBelow(bilinear, 0.375, 0.2), red * 0.75 + green * 0.25));
    CHECK(sameColour(colourBelow(bilinear, 0.5, 0.5), (red + green + blue + white) * 0.25));

    // At 0.05 the bilinear cell reaches beyond the picture by 0.2 of a texel's 0.5.
    const SceneTracer withBorder(
        *createPictureQuad(osg::Texture::LINEAR, osg::Texture::CLAMP_TO_BORDER));
    CHECK(sameColour(colourBelow(withBorder, 0.05, 0.25), red * 0.6 + border * 0.4));
    const SceneTracer repeatedLinear(
        *createPictureQuad(osg::Texture::LINEAR, osg::Texture::REPEAT));
    CHECK(sameColour(colourBelow(repeatedLinear, 0.05, 0.25), red * 0.6 + green * 0.4));

    // Texture coordinates from 0 to 2: the second copy, as it is and mirrored.
    const SceneTracer repeated(
        *createPictureQuad(osg::Texture::NEAREST, osg::Texture::REPEAT, 2.0f));
    CHECK(sameColour(colourBelow(repeated, 0.6, 0.1), red));
    CHECK(sameColour(colourBelow(repeated, 0.9, 0.1), green));
    const SceneTracer mirrored(
        *createPictureQuad(osg::Texture::NEAREST, osg::Texture::MIRROR, 2.0f));
    CHECK(sameColour(colourBelow(mirrored, 0.6, 0.1), green));
    CHECK(sameColour(colourBelow(mirrored, 0.9, 0.1), red));
}

// Falls when trace() ignores `nearest` (passBeforeNearest is not set as the filter).
TEST_CASE("hits before the nearest place that counts are passed, to a rounding")
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(createTriangle(nullptr, 1.0f));
    scene->addChild(createTriangle(nullptr, 0.0f));
    const SceneTracer tracer(*scene);
    const osg::Vec3d above(0.2, 0.2, 3.0);
    CHECK(tracer.trace(above, DOWN)->t == Approx(2.0));
    CHECK(tracer.trace(above, DOWN, 2.0 - 1e-12)->t == Approx(2.0));
    CHECK(tracer.trace(above, DOWN, 2.0 + 1e-12)->t == Approx(3.0));
    CHECK_FALSE(tracer.trace(above, DOWN, 3.0 + 1e-12));

    CHECK(tracer.occluded(above, osg::Vec3d(0.2, 0.2, -1)));
    CHECK_FALSE(tracer.occluded(above, osg::Vec3d(0.2, 0.2, 1.1)));
    CHECK_FALSE(tracer.occluded(above, osg::Vec3d(0.2, 0.2, 0.9), 0.2));
    CHECK(tracer.occluded(above, osg::Vec3d(0.2, 0.2, 0.5), 0.2));
}

// Falls when trace() does not look whether its origin, or the nearest place, is finite: Embree does
// not, either.
TEST_CASE("rays that are not finite hit nothing")
{
    const osg::ref_ptr<osg::Geometry> triangle = createTriangle();
    const SceneTracer tracer(*triangle);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const osg::Vec3d origin(0.2, 0.2, 10);
    REQUIRE(tracer.trace(origin, DOWN));
    for (double bad : {nan, infinity, -infinity})
        for (int axis = 0; axis < 3; ++axis)
        {
            osg::Vec3d badOrigin = origin;
            badOrigin[axis] = bad;
            osg::Vec3d badDir = DOWN;
            badDir[axis] = bad;
            CHECK_FALSE(tracer.trace(badOrigin, DOWN));
            CHECK_FALSE(tracer.trace(origin, badDir));
            CHECK_FALSE(tracer.occluded(badOrigin, origin));
            CHECK_FALSE(tracer.occluded(origin, badOrigin));
        }
    CHECK_FALSE(tracer.trace(origin, DOWN, nan));
    CHECK_FALSE(tracer.trace(origin, osg::Vec3d()));

    // Corners that are not finite are left out, with their triangles.
    (*static_cast<osg::Vec3Array*>(triangle->getVertexArray()))[0].x() = nan;
    CHECK(SceneTracer(*triangle).triangleCount() == 0);
}
