// The frame as drawn so far, copied in the middle of its draw.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/CopiedView.h"
#include "support/Scenes.h"

#include <osg/ColorMask>
#include <osg/Scissor>

#include <algorithm>
#include <cmath>

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;
const double STEP = 1.0 / ((1 << 24) - 1); // of a windowZ of 24 bits

float windowZAt(const osg::Image& image, int x, int y)
{
    return *reinterpret_cast<const float*>(image.data(x, y));
}

// Largest difference of windowZ.
double differenceOfWindowZ(const osg::Image& a, const osg::Image& b)
{
    REQUIRE(a.s() == b.s());
    REQUIRE(a.t() == b.t());
    double largest = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
            largest = std::max(largest, std::abs(double(windowZAt(a, x, y)) - windowZAt(b, x, y)));
    return largest;
}

int countBackground(const osg::Image& windowZ)
{
    int count = 0;
    for (int y = 0; y < windowZ.t(); ++y)
        for (int x = 0; x < windowZ.s(); ++x)
            count += windowZAt(windowZ, x, y) == 1.0f;
    return count;
}

osg::ref_ptr<osg::Texture2D> createDepth(GLint internalFormat)
{
    osg::ref_ptr<osg::Texture2D> texture = createWindowZTexture(WIDTH, HEIGHT);
    texture->setInternalFormat(internalFormat);
    if (internalFormat == GL_DEPTH24_STENCIL8_EXT)
    {
        texture->setSourceFormat(GL_DEPTH_STENCIL_EXT);
        texture->setSourceType(GL_UNSIGNED_INT_24_8_EXT);
    }
    return texture;
}

} // namespace

// Breaks where FrameImages::copy leaves the viewport's offset out, where RenderStateGuard lets the
// scene's state reach the copy, or where require() reads the projection before OSG has fitted it.
TEST_CASE("a copied frame is what has been drawn before the water")
{
    CopiedView view;
    osg::Camera& camera = view.camera();
    const osg::ref_ptr<osg::Group> scene = scenes::together(
        {createCurtain(9), view.copier, scenes::createHarbour(), view.reader, createCurtain(10)});
    SECTION("to a window") {}
    SECTION("to a part of a window")
    {
        camera.setViewport(21, 13, 97, 75);
    }
    SECTION("to a frame buffer object of bytes")
    {
        view.renderTo(GL_RGBA8);
    }
    SECTION("of floats")
    {
        view.renderTo(GL_RGBA16F_ARB);
    }
    SECTION("with a texture for its depth")
    {
        view.renderTo(GL_RGBA8);
        camera.attach(osg::Camera::DEPTH_BUFFER, createDepth(GL_DEPTH_COMPONENT24));
        camera.setViewport(21, 13, 97, 75);
    }
    SECTION("of 16 bits")
    {
        view.renderTo(GL_RGBA8);
        camera.attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT16);
    }
    SECTION("of floats for depth")
    {
        view.renderTo(GL_RGBA32F_ARB);
        camera.attach(osg::Camera::DEPTH_BUFFER, createDepth(GL_DEPTH_COMPONENT32F));
    }
    SECTION("of depth and stencil packed")
    {
        view.renderTo(GL_RGBA8);
        camera.attach(osg::Camera::PACKED_DEPTH_STENCIL_BUFFER, GL_DEPTH24_STENCIL8_EXT);
    }
    SECTION("of depth and stencil in a texture")
    {
        view.renderTo(GL_RGBA8);
        camera.attach(osg::Camera::PACKED_DEPTH_STENCIL_BUFFER,
                      createDepth(GL_DEPTH24_STENCIL8_EXT));
    }
    SECTION("under state that overrides all below it")
    {
        const unsigned int force = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
        osg::StateSet& loud = *scene->getOrCreateStateSet();
        loud.setAttributeAndModes(createColourProgram("first"), force);
        loud.addUniform(new osg::Uniform("first", osg::Vec4(0, 1, 0, 1)), force);
        loud.setAttribute(new osg::ColorMask(true, true, false, true), force);
        loud.setAttributeAndModes(new osg::Scissor(10, 10, 120, 80), force);
        loud.setMode(GL_BLEND, force);
    }
    for (int frame = 0; frame < 2; ++frame)
    {
        view.render(scene);
        const osg::ref_ptr<osg::Image> colour = view.copiedColour();
        const osg::ref_ptr<osg::Image> windowZ = view.copiedWindowZ();
        CHECK(countDifferent(*colour, *view.reader->colour) == 0);
        CHECK(differenceOfWindowZ(*windowZ, *view.reader->windowZ) <= 2.01 * STEP);
        CHECK(countBackground(*windowZ) == countBackground(*view.reader->windowZ));
        CHECK(countBackground(*windowZ) > 1000);
        CHECK(countBackground(*windowZ) < WIDTH * HEIGHT - 2000);
    }
}

// Breaks where FrameImages::copy does not resolve, or where RenderStateGuard does not apply its
// empty stack: the scissor stays.
TEST_CASE("the samples of a frame buffer object are resolved into its copy")
{
    const osg::ref_ptr<osg::Node> harbour = scenes::createHarbour();
    CopiedView plain;
    plain.renderTo(GL_RGBA8);
    plain.render(scenes::together({harbour, plain.copier, createCurtain(9)}));
    const osg::ref_ptr<osg::Image> plainColour = plain.copiedColour();
    const osg::ref_ptr<osg::Image> plainWindowZ = plain.copiedWindowZ();

    CopiedView view;
    view.renderTo(GL_RGBA8, 4);
    SECTION("with a depth of OSG's choice") {}
    SECTION("of 16 bits")
    {
        view.camera().attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT16);
    }
    SECTION("of floats")
    {
        view.camera().attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT32F);
    }
    SECTION("with a stencil")
    {
        view.camera().attach(osg::Camera::PACKED_DEPTH_STENCIL_BUFFER, GL_DEPTH24_STENCIL8_EXT);
    }
    // What is drawn last before it leaves a scissor behind, which blits heed.
    const osg::ref_ptr<osg::Node> cut = createCurtain(7);
    cut->getOrCreateStateSet()->setAttributeAndModes(new osg::Scissor(0, 0, 1, 1));
    view.render(scenes::together({harbour, view.copier, cut, createCurtain(9)}));
    const osg::ref_ptr<osg::Image> colour = view.copiedColour();
    const osg::ref_ptr<osg::Image> windowZ = view.copiedWindowZ();

    // A pixel's samples lie between its neighbours, but for a few where an edge's tip is.
    int outside = 0;
    int changed = 0;
    for (int y = 1; y < HEIGHT - 1; ++y)
        for (int x = 1; x < WIDTH - 1; ++x)
        {
            osg::Vec4 low(1, 1, 1, 1), high(0, 0, 0, 0);
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                {
                    osg::Vec4 near = pixel(*plainColour, x + i, y + j);
                    near.a() = windowZAt(*plainWindowZ, x + i, y + j);
                    for (int k = 0; k < 4; ++k)
                    {
                        low[k] = std::min(low[k], near[k]);
                        high[k] = std::max(high[k], near[k]);
                    }
                }
            osg::Vec4 resolved = pixel(*colour, x, y);
            changed += resolved != pixel(*plainColour, x, y);
            resolved.a() = windowZAt(*windowZ, x, y);
            bool between = true;
            for (int k = 0; k < 4; ++k)
                between = between && resolved[k] >= low[k] - 0.02 && resolved[k] <= high[k] + 0.02;
            outside += !between;
        }
    CHECK(outside < WIDTH * HEIGHT / 100);
    CHECK(changed > WIDTH * HEIGHT / 100); // samples there were
}

// Breaks where windowZ is copied as it is.
TEST_CASE("a copy's windowZ is that of the scene drawn with the capture's own projection")
{
    const osg::ref_ptr<osg::Group> harbour = scenes::createHarbour();
    CopiedView view;
    view.renderTo(GL_RGBA8);
    OffscreenView direct(WIDTH, HEIGHT, OffscreenView::Format::RGBA32F);
    direct.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    direct.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    direct.camera().attach(osg::Camera::DEPTH_BUFFER, createWindowZTexture(WIDTH, HEIGHT));
    const osg::ref_ptr<CapturedImages> images = CapturedImages::of(direct.camera());

    const double aspect = double(WIDTH) / HEIGHT;
    osg::Matrixd projection;
    double slope = 0.2; // at most: how many steps of the copy's a step of the frame's is
    SECTION("in perspective, OSG having fitted the frame's near and far")
    {
        projection.makePerspective(46.0, aspect, 0.5, 400.0);
    }
    SECTION("in perspective, from a frame of little precision")
    {
        view.camera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        projection.makePerspective(46.0, aspect, 5.0, 60.0);
        slope = 55.0; // about as many times as 5 is 0.1
    }
    SECTION("off the axis")
    {
        view.camera().setProjectionMatrixAsFrustum(-0.05, 0.02, -0.01, 0.06, 0.1, 1000.0);
        projection.makeFrustum(-0.25, 0.1, -0.05, 0.3, 0.5, 200.0);
    }
    SECTION("orthographic")
    {
        view.camera().setProjectionMatrixAsOrtho(-7, 7, -5, 5, 1.0, 300.0);
        projection.makeOrtho(-7, 7, -5, 5, 0.5, 90.0);
    }
    view.copy->projection = new osg::RefMatrix(projection);
    view.render(scenes::together({view.copier, harbour, view.reader, createCurtain(9)}));
    direct.camera().setProjectionMatrix(projection);
    direct.render(harbour);

    const osg::ref_ptr<osg::Image> windowZ = view.copiedWindowZ();
    const osg::Image& drawn = *images->frameWindowZ;
    CHECK(countBackground(drawn) > 1000);
    CHECK(countBackground(*windowZ) == countBackground(drawn));
    // What a rasteriser computes in single precision is uncertain by some steps, in both pictures.
    CHECK(differenceOfWindowZ(*windowZ, drawn) <= (8.0 + 4.0 * slope) * STEP);

    const osg::Matrixd ndcFromNdc =
        osg::Matrixd::inverse(*view.copy->one().frameProjection) * projection;
    double largest = 0.0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
        {
            const double frameZ = windowZAt(*view.reader->windowZ, x, y);
            const double exact = 0.5 + 0.5 * (osg::Vec3d(0, 0, 2 * frameZ - 1) * ndcFromNdc).z();
            if (frameZ < 1.0)
                largest = std::max(largest, std::abs(windowZAt(*windowZ, x, y) - exact));
        }
    // Single precision tells frameZ to a step.
    CHECK(largest <= (2.0 + slope) * STEP);
}

// Its camera renders the capture's band first, as a capture does.
TEST_CASE("what a capture shows beside the frame's place stays as it was")
{
    CopiedView view;
    SECTION("of the same scale") {}
    SECTION("of another scale, by the nearest pixels")
    {
        view.copy->scale = 0.5;
    }
    view.copy->origin = osg::Vec2i(7, 5);
    const int width = view.copy->scale * WIDTH;
    const int height = view.copy->scale * HEIGHT;
    osg::ref_ptr<osg::Group> scene =
        scenes::together({scenes::createHarbour(), view.copier, view.reader});
    view.render(scene);
    CopiedCapture& capture = view.copy->one();
    capture.camera->setClearColor(osg::Vec4(0.2, 0.4, 0.6, 1.0));
    capture.camera->setClearDepth(0.25);
    capture.camera->setCullCallback(new osg::NodeCallback); // or OSG drops it, empty as it is
    capture.camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    osg::ref_ptr<osg::Node> far = scenes::createQuad(osg::Vec3(-1, -1, 0.5), osg::Vec3(2, 0, 0),
                                                     osg::Vec3(0, 2, 0), osg::Vec4(1, 0, 0, 1));
    capture.camera->addChild(far); // behind what is cleared
    scene->addChild(capture.camera);
    view.render(scene);

    const osg::ref_ptr<osg::Image> colour = view.copiedColour();
    const osg::ref_ptr<osg::Image> windowZ = view.copiedWindowZ();
    REQUIRE(colour->s() == width + 14);
    REQUIRE(colour->t() == height + 10);
    int wrong = 0;
    for (int y = 0; y < colour->t(); ++y)
        for (int x = 0; x < colour->s(); ++x)
        {
            const int i = x - 7;
            const int j = y - 5;
            osg::Vec4 expected(0.2, 0.4, 0.6, 1.0);
            double expectedZ = 0.25;
            if (i >= 0 && j >= 0 && i < width && j < height)
            {
                const int pixelX = (i + 0.5) / view.copy->scale;
                const int pixelY = (j + 0.5) / view.copy->scale;
                expected = pixel(*view.reader->colour, pixelX, pixelY);
                expectedZ = windowZAt(*view.reader->windowZ, pixelX, pixelY);
            }
            wrong += (pixel(*colour, x, y) - expected).length() > 0.001 ||
                     std::abs(windowZAt(*windowZ, x, y) - expectedZ) > 2.01 * STEP;
        }
    CHECK(wrong == 0);
}
// Breaks where ImageStage::releaseGLObjects does not dirty its array.
TEST_CASE("a copy follows its view's size, and holds nothing once released")
{
    CopiedView view;
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({view.copier, scenes::createHarbour(), view.reader, createCurtain(9)});
    view.copy->least = osg::Vec2i(WIDTH, HEIGHT);
    const auto check = [&](int width, int height)
    {
        view.render(scene);
        const osg::ref_ptr<osg::Image> colour = view.copiedColour();
        const osg::ref_ptr<osg::Image> windowZ = view.copiedWindowZ();
        int wrong = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                wrong += pixel(*colour, x, y) != pixel(*view.reader->colour, x, y) ||
                         std::abs(windowZAt(*windowZ, x, y) -
                                  windowZAt(*view.reader->windowZ, x, y)) > 2.01 * STEP;
        CHECK(wrong == 0);
    };
    view.camera().setViewport(0, 0, 80, 60);
    check(80, 60);
    view.camera().setViewport(0, 0, WIDTH, HEIGHT);
    check(WIDTH, HEIGHT);
    view.camera().setViewport(0, 0, 131, 97);
    check(131, 97);
    const auto numTextures = [&]
    {
        view.camera().getGraphicsContext()->makeCurrent();
        unsigned int count = 0;
        osg::flushAllDeletedGLObjects(view.state().getContextID());
        for (unsigned int name = 1; name < 1000; ++name)
            count += glIsTexture(name);
        view.camera().getGraphicsContext()->releaseContext();
        return count;
    };
    const unsigned int before = numTextures();
    view.copy->one().release();
    CHECK(numTextures() == before - 4); // the frame's images and the capture's
    check(131, 97);
    CHECK(numTextures() == before);
    scene->resizeGLObjectBuffers(64);
    view.copy->one().copy->resizeGLObjectBuffers(64);
    check(131, 97);
}
