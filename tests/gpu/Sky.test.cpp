#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/Program>
#include <osg/ShapeDrawable>
#include <osgParticle/ParticleSystem>

#include <algorithm>
#include <cmath>

using osgWaterReflect::WaterSurface;

namespace
{

const osg::Vec4 RED(1, 0, 0, 1);
const osg::Vec4 WHITE(1, 1, 1, 1);

struct SkyView : OffscreenView
{
    SkyView() : OffscreenView(160, 120, Format::RGBA32F), captured(CapturedImages::of(camera()))
    {
        camera().setClearColor(osg::Vec4(0.25, 0.5, 0.75, 1));
    }
    osg::ref_ptr<CapturedImages> captured;
};

osg::ref_ptr<WaterSurface> createMirror()
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake(0.0, 400.0);
    lake->setDebugView(WaterSurface::DebugView::REFLECTION);
    return lake;
}

// Of each face, by its order in OpenGL: +x -x +y -y +z -z.
const osg::Vec4 FACES[] = {osg::Vec4(1, 0, 0, 1), osg::Vec4(0.5, 0, 0, 1),
                           osg::Vec4(0, 1, 0, 1), osg::Vec4(0, 0.5, 0, 1),
                           osg::Vec4(0, 0, 1, 1), osg::Vec4(0, 0, 0.5, 1)};

osg::ref_ptr<osg::TextureCubeMap> createSky()
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        for (int i = 0; i < 16; ++i)
            image->setColor(FACES[face], i % 4, i / 4);
        sky->setImage(face, image);
    }
    sky->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    sky->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return sky;
}

// The face that a direction in world space meets: its greatest coordinate's.
unsigned int faceOf(const osg::Vec3d& dir)
{
    unsigned int axis = 0;
    for (unsigned int i = 1; i < 3; ++i)
        if (std::abs(dir[i]) > std::abs(dir[axis])) axis = i;
    return 2 * axis + (dir[axis] < 0.0);
}

// Direction from the eye through a pixel's centre.
osg::Vec3d directionOf(const osg::Camera& camera, double x, double y)
{
    const osg::Matrixd worldFromWindow =
        osg::Matrixd::inverse(camera.getViewMatrix() * camera.getProjectionMatrix() *
                              camera.getViewport()->computeWindowMatrix());
    osg::Vec3d dir = osg::Vec3d(x + 0.5, y + 0.5, 1.0) * worldFromWindow -
                     osg::Vec3d(x + 0.5, y + 0.5, 0.0) * worldFromWindow;
    dir.normalize();
    return dir;
}

// A ball about the eye whose colours are directions, drawn first and without depth.
osg::ref_ptr<osg::Node> createDome(const osg::Vec3d& centre)
{
    osg::ref_ptr<osg::Geode> dome = new osg::Geode;
    dome->addDrawable(new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(centre), 100.0f)));
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, R"glsl(#version 130
        uniform vec3 centre;
        varying vec3 dir;
        void main()
        {
            dir = gl_Vertex.xyz - centre;
            gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
        })glsl"));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, R"glsl(#version 130
        varying vec3 dir;
        out vec4 colour;
        void main() { colour = vec4(0.5 + 0.5 * normalize(dir), 1.0); })glsl"));
    osg::StateSet* stateSet = dome->getOrCreateStateSet();
    stateSet->addUniform(new osg::Uniform("centre", osg::Vec3(centre)));
    stateSet->setAttribute(program);
    stateSet->setAttribute(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    stateSet->setRenderBinDetails(-1, "RenderBin");
    return dome;
}

} // namespace

// Breaks where skyColour (sky.glsl) looks dirEye up.
TEST_CASE("the sky's cube map is looked up with the reflected direction in world space")
{
    SkyView view;
    const osg::Vec3d eye(0, 0, 2);
    const osg::Vec3d target =
        GENERATE(osg::Vec3d(5, 0, 0), osg::Vec3d(-5, 0, 0), osg::Vec3d(0, 5, 0),
                 osg::Vec3d(0, -5, 0), osg::Vec3d(1, 1, 0), osg::Vec3d(0.4, 0.2, 0));
    view.look(eye, target, 60.0);
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    lake->setSky(createSky());
    const osg::Image& picture = view.render(lake);
    int checked = 0;
    for (int y = 0; y < 120; y += 3)
        for (int x = 0; x < 160; x += 3)
        {
            osg::Vec3d dir = directionOf(view.camera(), x, y);
            if (dir.z() > -0.05) continue; // not water
            dir.z() = -dir.z();
            // Not close to where two faces meet: half a degree for rounding.
            osg::Vec3d sorted(std::abs(dir.x()), std::abs(dir.y()), std::abs(dir.z()));
            std::sort(sorted.ptr(), sorted.ptr() + 3);
            if (sorted[2] - sorted[1] < 0.01) continue;
            INFO("pixel " << x << ", " << y << " face " << faceOf(dir));
            // Faces of 8 bits.
            REQUIRE((pixel(picture, x, y) - FACES[faceOf(dir)]).length() < 0.01f);
            ++checked;
        }
    CHECK(checked > 300);
}

// Breaks where skyColour looks at the ray's start instead of where it is last seen (skyWindow).
TEST_CASE("without a cube map the dome that the scene draws without depth is the sky")
{
    // A level view: the sky over each column of water is in the picture.
    SkyView view;
    const osg::Vec3d eye(0, 0, 2);
    view.look(eye, osg::Vec3d(3, 10, 2), 60.0);
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    const osg::ref_ptr<osg::Node> dome = createDome(eye);
    const osg::Image& picture = view.render(scenes::together({dome, lake}));
    int checked = 0;
    for (int y = 1; y < 56; ++y)
        for (int x = 1; x < 159; ++x)
        {
            osg::Vec3d dir = directionOf(view.camera(), x, y);
            dir.z() = -dir.z();
            const osg::Vec4 expected(0.5 + 0.5 * dir.x(), 0.5 + 0.5 * dir.y(), 0.5 + 0.5 * dir.z(),
                                     1.0);
            // A pixel of 60 degrees in 120 and half a pixel's search: 0.009 rad, half of it in
            // colour; the dome is a polyhedron, which bends its normals by as much again.
            REQUIRE((pixel(picture, x, y) - expected).length() < 0.02f);
            ++checked;
        }
    CHECK(checked > 8000);
}

// Breaks where the sky is looked for along the image's columns whichever way the camera is rolled,
// or where SkyImage is not told the way up.
TEST_CASE("behind things the sky above them is seen, however the camera is rolled")
{
    // A wall along the water's far side hides where most rays are last seen; above it the dome is
    // in sight, in each picture.
    const double roll = osg::DegreesToRadians(GENERATE(0.0, 45.0, 90.0, 135.0, 180.0, 270.0));
    SkyView view;
    const osg::Vec3d eye(0, -10, 3);
    const osg::Vec3d centre(0, 10, 2.5);
    view.camera().setViewMatrixAsLookAt(eye, centre,
                                        osg::Vec3d(std::sin(roll), 0.0, std::cos(roll)));
    view.camera().setProjectionMatrixAsPerspective(60.0, 160.0 / 120.0, 0.1, 1000.0);
    const osg::Vec4 clear(10, 10, 10, 1); // as nothing in the scene is
    view.camera().setClearColor(clear);
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    const osg::ref_ptr<osg::Node> wall =
        scenes::createBox(osg::Vec3(0, 40, 4), osg::Vec3(400, 1, 8), RED);
    const osg::Image& picture =
        view.render(scenes::together({createDome(eye), wall, scenes::withoutBand(lake)}));
    int sky = 0;
    int blank = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
        {
            const osg::Vec4 colour = pixel(picture, x, y);
            blank += (colour - clear).length() < 1.0f;
            sky += (colour - RED).length() > 0.1f;
        }
    INFO("rolled by " << osg::RadiansToDegrees(roll));
    CHECK(sky > 3000);
    CHECK(blank == 0);
}

// Breaks where skyColour walks along the image, as it once did, or where it is asked for hits.
TEST_CASE("the sky that the scene draws costs two fetches at most, and hits none")
{
    SkyView view;
    view.look(osg::Vec3d(0, -10, 3), osg::Vec3d(0, 10, 1));
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createBox(osg::Vec3(0, 40, 20), osg::Vec3(120, 1, 60), RED),
                          scenes::createBox(osg::Vec3(-3, 5, 1), osg::Vec3(2, 2, 4), WHITE), lake});
    lake->setDebugView(WaterSurface::DebugView::HIT);
    const osg::ref_ptr<osg::Image> drawn = copyOf(view.render(scene));
    lake->setSky(createSky());
    const osg::Image& mapped = view.render(scene);
    int hits = 0;
    int others = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
        {
            const osg::Vec4 with = pixel(*drawn, x, y);
            const osg::Vec4 without = pixel(mapped, x, y);
            if (without.a() < 1.0f || without.a() != std::floor(without.a())) continue; // no water
            const bool hit = without.b() == 0.0f;
            const float more = with.a() - without.a();
            REQUIRE(more >= 0.0f);
            REQUIRE(more <= (hit ? 0.0f : 2.0f));
            ++(hit ? hits : others);
        }
    CHECK(hits > 1000);
    CHECK(others > 500);
}

// Breaks where skyColour returns black in place of clearColour.
TEST_CASE("without a dome the clear colour is the sky, wherever the ray goes")
{
    SkyView view;
    view.look(osg::Vec3d(0, -10, 3), osg::Vec3d(0, 0, 0));
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    const osg::ref_ptr<osg::Node> wall =
        scenes::createBox(osg::Vec3(0, 30, 50), osg::Vec3(200, 1, 100.4), RED);
    SECTION("over empty water")
    {
        const osg::Image& picture = view.render(lake);
        for (int y = 0; y < 60; y += 7)
            for (int x = 0; x < 160; x += 7)
                REQUIRE((pixel(picture, x, y) - osg::Vec4(0.25, 0.5, 0.75, 1)).length() < 1e-6f);
    }
    SECTION("where nothing of the sky is in sight, too")
    {
        // 10 degrees down: the picture ends 13 degrees above the horizon, all of them wall, and
        // the lowest rays rise by more.
        view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 2.0 - 10.0 * std::tan(M_PI / 18.0)));
        view.render(scenes::together({wall, scenes::withoutBand(lake)}));
        view.camera().setClearColor(osg::Vec4(0.75, 0.25, 0.5, 1));
        const osg::Image& picture = view.render(view.viewer().getSceneData());
        for (int x = 0; x < 160; x += 7)
            CHECK((pixel(picture, x, 5) - osg::Vec4(0.75, 0.25, 0.5, 1)).length() < 1e-6f);
        CHECK((pixel(picture, 80, 70) - RED).length() < 0.01f);
    }
}

// Leaves on a card: blended, without depth. Rays are followed through depth alone, so the card
// itself is not hit; but its colour is part of whatever lies behind it in the picture.
// Breaks where WaterDraw draws water in a bin after 10.
TEST_CASE("what is blended is drawn over the water, and is no obstacle to reflected rays")
{
    SkyView view;
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 2));
    const osg::ref_ptr<WaterSurface> lake = createMirror();
    const osg::ref_ptr<osg::Node> wall =
        scenes::createBox(osg::Vec3(0, 60, 10), osg::Vec3(160, 1, 20.4), RED);
    const osg::ref_ptr<osg::Group> root = scenes::together({wall, lake});
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(root));

    // Half transparent, from 1 m over the water up.
    const osg::Vec4 green(0, 1, 0, 0.5); // its alpha is its share
    const osg::ref_ptr<osg::Node> card =
        scenes::createQuad(osg::Vec3(-3, 0, 1), osg::Vec3(6, 0, 0), osg::Vec3(0, 0, 2), green);
    osg::StateSet* stateSet = card->getOrCreateStateSet();
    stateSet->setMode(GL_BLEND, osg::StateAttribute::ON);
    stateSet->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    stateSet->setAttribute(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    root->insertChild(0, card);
    const osg::ref_ptr<osg::Image> with = copyOf(view.render(root));

    // 60 / tan 23 degrees = 141 px a metre at 1 m. The card reaches from 1 m under the eye to 1 m
    // over it at 10 m: rows 46 to 74. The wall's foot is 2 m under it at 69.5 m: row 56, where its
    // reflection begins, upside down. So the wall's rows 57 to 74, through the card, are reflected
    // in rows 55 to 38, with the colours of both; what is above the card in the rows below.
    const osg::Vec4 throughCard = pixel(*view.captured->one().colour, 80, 65);
    CHECK((throughCard - osg::Vec4(0.5, 0.5, 0, throughCard.a())).length() < 0.01f);
    for (int y = 20; y < 55; ++y)
    {
        INFO("row " << y);
        CHECK(pixel(*without, 80, y).r() == Approx(1.0).margin(0.01));
        const bool underCard = y > 46;
        if (std::abs(y - 38) < 3 || std::abs(y - 46) < 3) continue; // edges of the card
        const osg::Vec4 reflected = y > 38 ? throughCard : RED;
        const osg::Vec4 expected = underCard ? reflected * 0.5f + green * 0.5f : reflected;
        for (int i = 0; i < 2; ++i)
            CHECK(pixel(*with, 80, y)[i] == Approx(expected[i]).margin(0.01));
    }
}

// Breaks where search_sequential.glsl does not ask for surfaceZ < 1.
TEST_CASE("a particle system is drawn with and without water alike, and is reflected as colour")
{
    osg::ref_ptr<osgParticle::ParticleSystem> particles = new osgParticle::ParticleSystem;
    particles->setDefaultAttributes("", false, false);
    for (int i = 0; i < 40; ++i)
    {
        osgParticle::Particle pattern;
        pattern.setLifeTime(1000.0);
        pattern.setSizeRange(osgParticle::rangef(0.3f, 0.3f));
        pattern.setColorRange(osgParticle::rangev4(WHITE, WHITE));
        pattern.setAlphaRange(osgParticle::rangef(1, 1));
        osgParticle::Particle* particle = particles->createParticle(&pattern);
        particle->setPosition(osg::Vec3(-4.0f + 0.2f * i, 1.0f, 1.5f + 0.05f * (i % 7)));
    }
    osg::NodeVisitor noVisitor;
    particles->update(0.01, noVisitor); // gives them size and colour
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(particles);

    SkyView view;
    view.look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 1));
    const osg::ref_ptr<osg::Image> frame = copyOf(view.render(scenes::together({geode})));
    const osg::ref_ptr<osg::Image> mask =
        copyOf(view.render(scenes::together({geode, scenes::createStandIn()})));
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setDebugView(WaterSurface::DebugView::REASON);
    const osg::ref_ptr<osg::Group> root = scenes::together({geode, lake});
    const osg::Image& picture = view.render(root);
    const CapturedImage& capture = view.captured->one();
    CHECK(countDifferent(*capture.colour, *frame) == 0);
    CHECK(scenes::countDifferentOutsideStandIn(*mask, picture, *mask) == 0);
    int coloured = 0;
    int hits = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
        {
            coloured += pixel(*capture.colour, x, y).r() > 0.5f;
            hits += (pixel(picture, x, y) - osg::Vec4(0.1, 0.7, 0.1, 1)).length() < 0.01f;
            REQUIRE(pixel(*capture.windowZ, x, y).r() == 1.0f); // no depth of theirs
        }
    CHECK(coloured > 50);
    CHECK(hits == 0);
}
