// The frame as drawn so far, copied in the middle of its draw; and what is drawn after that.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/HarbourWindow.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/capture/FrameCopy.h>
#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Drawable>
#include <osg/GLExtensions>
#include <osg/PolygonMode>
#include <osg/Scissor>
#include <osg/TexEnv>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

using osgWaterReflect::FrameCopy;
using osgWaterReflect::ImageStage;

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;
const double STEP = 1.0 / ((1 << 24) - 1); // of a windowZ of 24 bits

osg::ref_ptr<osg::Image> readTexture(osg::State& state, osg::Texture2D& texture, GLenum format)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texture.getTextureWidth(), texture.getTextureHeight(), 1,
                         format == GL_DEPTH_COMPONENT ? GL_LUMINANCE : format, GL_FLOAT);
    state.applyTextureAttribute(0, &texture);
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, image->data());
    return image;
}

// A capture's images, and the copy into them, for one camera of one view.
struct Capture
{
    Capture(int width, int height, GLint colourFormat) :
        copy(new FrameCopy), colour(new osg::Texture2D),
        windowZ(createWindowZTexture(width, height)), camera(new osg::Camera)
    {
        colour->setInternalFormat(colourFormat);
        colour->setTextureSize(width, height);
        for (osg::Texture2D* texture : {colour.get(), windowZ.get()})
        {
            texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
            texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
            texture->setResizeNonPowerOfTwoHint(false);
        }
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        camera->setViewport(0, 0, width, height);
        camera->attach(osg::Camera::COLOR_BUFFER0, colour);
        camera->attach(osg::Camera::DEPTH_BUFFER, windowZ);
    }
    void release()
    {
        copy->releaseGLObjects(nullptr);
        colour->releaseGLObjects(nullptr);
        windowZ->releaseGLObjects(nullptr);
    }
    osg::ref_ptr<FrameCopy> copy;
    osg::ref_ptr<osg::Texture2D> colour;
    osg::ref_ptr<osg::Texture2D> windowZ;
    osg::ref_ptr<osg::Camera> camera;
    osg::ref_ptr<osg::RefMatrix> frameProjection; // once drawn: as OSG has fitted it
};

// Copies the frame of every view that culls its node.
class CopyFrame : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        osgUtil::CullVisitor& view = *visitor->asCullVisitor();
        if (!enabled) return;
        const osg::Viewport& viewport = *view.getCurrentRenderStage()->getViewport();
        osg::ref_ptr<osg::Viewport> place = new osg::Viewport(
            origin.x(), origin.y(), scale * viewport.width(), scale * viewport.height());
        std::unique_ptr<Capture>& capture = captures[{visitor, view.getCurrentCamera()}];
        if (!capture)
            capture = std::make_unique<Capture>(
                std::max(least.x(), int(place->width()) + 2 * origin.x()),
                std::max(least.y(), int(place->height()) + 2 * origin.y()), colourFormat);
        osg::RefMatrix& frame = *view.getProjectionMatrix();
        capture->frameProjection = &frame;
        capture->copy->require(view, *capture->camera, *place, projection ? *projection : frame);
        arranged(*capture, view);
        traverse(node, visitor);
    }

    Capture& one()
    {
        REQUIRE(captures.size() == 1);
        return *captures.begin()->second;
    }

    bool enabled = true;
    osg::Vec2i origin{0, 0};
    osg::Vec2i least{0, 0}; // [pixels] size of a capture
    double scale = 1.0;
    GLint colourFormat = GL_RGBA8;
    osg::ref_ptr<osg::RefMatrix> projection; // null: the frame's own
    std::function<void(Capture&, osgUtil::CullVisitor&)> arranged = [](auto&, auto&) {};
    std::map<std::pair<osg::NodeVisitor*, osg::Camera*>, std::unique_ptr<Capture>> captures;
};

osg::ref_ptr<osg::Group> createCopier(CopyFrame& copy)
{
    osg::ref_ptr<osg::Group> node = new osg::Group;
    node->setCullCallback(&copy);
    node->setCullingActive(false);
    return node;
}

// Draws nothing, but reads what has been drawn.
class ReadFrame : public osg::Drawable
{
public:
    ReadFrame()
    {
        setCullingActive(false);
        setUseDisplayList(false);
        getOrCreateStateSet()->setRenderBinDetails(7, "RenderBin");
    }
    META_Object(test, ReadFrame)
    ReadFrame(const ReadFrame& rhs, const osg::CopyOp& copyop) : osg::Drawable(rhs, copyop) {}

    void drawImplementation(osg::RenderInfo& renderInfo) const override
    {
        const osg::Viewport& part = *renderInfo.getState()->getCurrentViewport();
        colour = new osg::Image;
        windowZ = new osg::Image;
        colour->allocateImage(part.width(), part.height(), 1, GL_RGBA, GL_FLOAT);
        windowZ->allocateImage(part.width(), part.height(), 1, GL_LUMINANCE, GL_FLOAT);
        glReadPixels(part.x(), part.y(), part.width(), part.height(), GL_RGBA, GL_FLOAT,
                     colour->data());
        glReadPixels(part.x(), part.y(), part.width(), part.height(), GL_DEPTH_COMPONENT, GL_FLOAT,
                     windowZ->data());
    }
    mutable osg::ref_ptr<osg::Image> colour;
    mutable osg::ref_ptr<osg::Image> windowZ;
};

osg::ref_ptr<osg::Program> createProgram(const char* uniform)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       std::string("#version 130\nuniform vec4 ") + uniform +
                                           ";\nvoid main() { gl_FragColor = " + uniform + "; }"));
    return program;
}

void setBin(osg::Node& node, int bin, const char* type = "RenderBin")
{
    node.getOrCreateStateSet()->setRenderBinDetails(bin, type);
}

// Something that is not to be copied: nearer than all of the harbour.
osg::ref_ptr<osg::Node> createCurtain(int bin)
{
    osg::ref_ptr<osg::Node> curtain = scenes::createQuad(osg::Vec3(-5, -9, 1), osg::Vec3(7, 0, 0),
                                                         osg::Vec3(0, 0, 3), osg::Vec4(1, 0, 1, 1));
    setBin(*curtain, bin);
    return curtain;
}

// A view of the harbour in which errors of OpenGL are left for OffscreenView to find.
struct CopiedView : HarbourWindow
{
    CopiedView() : copy(new CopyFrame), copier(createCopier(*copy)), reader(new ReadFrame)
    {
        state().setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
        camera().setPostDrawCallback(nullptr); // these captures are not the library's
    }
    osg::State& state() { return *camera().getGraphicsContext()->getState(); }

    // OSG looks functions up by name, and Mesa has this one without supporting it.
    void refuseCoverageSamples()
    {
        viewer().realize();
        camera().getGraphicsContext()->makeCurrent();
        state().get<osg::GLExtensions>()->glRenderbufferStorageMultisampleCoverageNV = nullptr;
        camera().getGraphicsContext()->releaseContext();
    }

    // Renders to textures in place of the window.
    void renderTo(GLint colourFormat, int samples = 0)
    {
        camera().detach(osg::Camera::COLOR_BUFFER);
        camera().setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        osg::ref_ptr<osg::Texture2D> colour = new osg::Texture2D;
        colour->setTextureSize(WIDTH, HEIGHT);
        colour->setInternalFormat(colourFormat);
        colour->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
        colour->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
        camera().attach(osg::Camera::COLOR_BUFFER0, colour, 0, 0, false, samples);
        if (samples) refuseCoverageSamples();
        copy->colourFormat = colourFormat;
    }

    osg::ref_ptr<osg::Image> copied(bool depth)
    {
        camera().getGraphicsContext()->makeCurrent();
        Capture& capture = copy->one();
        osg::ref_ptr<osg::Image> image =
            depth ? readTexture(state(), *capture.windowZ, GL_DEPTH_COMPONENT)
                  : readTexture(state(), *capture.colour, GL_RGBA);
        camera().getGraphicsContext()->releaseContext();
        return image;
    }

    osg::ref_ptr<CopyFrame> copy;
    osg::ref_ptr<osg::Group> copier;
    osg::ref_ptr<ReadFrame> reader;
};

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

// Breaks where FrameImages::copy leaves the viewport's offset out, where Interlude lets the scene's
// state reach the copy, or where require() reads the projection before OSG has fitted it.
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
        loud.setAttributeAndModes(createProgram("first"), force);
        loud.addUniform(new osg::Uniform("first", osg::Vec4(0, 1, 0, 1)), force);
        loud.setAttribute(new osg::ColorMask(true, true, false, true), force);
        loud.setAttributeAndModes(new osg::Scissor(10, 10, 120, 80), force);
        loud.setMode(GL_BLEND, force);
    }
    for (int frame = 0; frame < 2; ++frame)
    {
        view.render(scene);
        const osg::ref_ptr<osg::Image> colour = view.copied(false);
        const osg::ref_ptr<osg::Image> windowZ = view.copied(true);
        CHECK(countDifferent(*colour, *view.reader->colour) == 0);
        CHECK(differenceOfWindowZ(*windowZ, *view.reader->windowZ) <= 2.01 * STEP);
        CHECK(countBackground(*windowZ) == countBackground(*view.reader->windowZ));
        CHECK(countBackground(*windowZ) > 1000);
        CHECK(countBackground(*windowZ) < WIDTH * HEIGHT - 2000);
    }
}

// Breaks where FrameImages::copy does not resolve, or where Interlude does not apply its empty
// stack: the scissor stays.
TEST_CASE("the samples of a frame buffer object are resolved into its copy")
{
    const osg::ref_ptr<osg::Node> harbour = scenes::createHarbour();
    CopiedView plain;
    plain.renderTo(GL_RGBA8);
    plain.render(scenes::together({harbour, plain.copier, createCurtain(9)}));
    const osg::ref_ptr<osg::Image> plainColour = plain.copied(false);
    const osg::ref_ptr<osg::Image> plainWindowZ = plain.copied(true);

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
    const osg::ref_ptr<osg::Image> colour = view.copied(false);
    const osg::ref_ptr<osg::Image> windowZ = view.copied(true);

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

    const osg::ref_ptr<osg::Image> windowZ = view.copied(true);
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
    Capture& capture = view.copy->one();
    capture.camera->setClearColor(osg::Vec4(0.2, 0.4, 0.6, 1.0));
    capture.camera->setClearDepth(0.25);
    capture.camera->setCullCallback(new osg::NodeCallback); // or OSG drops it, empty as it is
    capture.camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    osg::ref_ptr<osg::Node> far = scenes::createQuad(osg::Vec3(-1, -1, 0.5), osg::Vec3(2, 0, 0),
                                                     osg::Vec3(0, 2, 0), osg::Vec4(1, 0, 0, 1));
    capture.camera->addChild(far); // behind what is cleared
    scene->addChild(capture.camera);
    view.render(scene);

    const osg::ref_ptr<osg::Image> colour = view.copied(false);
    const osg::ref_ptr<osg::Image> windowZ = view.copied(true);
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

namespace
{

osg::ref_ptr<osg::Node> quadAt(double x, double z, int bin, const osg::Vec4& colour)
{
    osg::ref_ptr<osg::Node> quad = scenes::createQuad(
        osg::Vec3(x, -6 + 0.1 * bin, z), osg::Vec3(1.5, 0, 0), osg::Vec3(0, 0, 1.0), colour);
    setBin(*quad, bin);
    return quad;
}

// Something of every kind of state, in bins before the copy and after it, under state that they
// share: what a copy leaves wrong shows.
osg::ref_ptr<osg::Group> createMotley()
{
    const osg::ref_ptr<osg::Group> motley = scenes::together({scenes::createHarbour()});
    const osg::ref_ptr<osg::Program> program = createProgram("first");
    const osg::ref_ptr<osg::Texture2D> chequers = scenes::createChequers();
    const osg::ref_ptr<osg::Scissor> scissor = new osg::Scissor(30, 20, 90, 70);
    const osg::ref_ptr<osg::ColorMask> mask = new osg::ColorMask(true, false, true, true);
    const osg::ref_ptr<osg::Viewport> viewport = new osg::Viewport(10, 5, 120, 90);
    for (int bin : {-1, 0, 7, 8, 9, 10, 11})
    {
        const char* type = bin == 10 ? "DepthSortedBin" : "RenderBin";
        const double z = -1.0 + 0.6 * (bin % 8);
        const osg::Vec4 colour(0.1 * (bin + 1), 1.0 - 0.08 * bin, 0.5, 0.6);
        const osg::ref_ptr<osg::Group> row = scenes::together({});
        for (int i = 0; i < 8; ++i)
        {
            const osg::ref_ptr<osg::Node> quad = quadAt(-6 + 1.6 * i, z, bin, colour);
            setBin(*quad, bin, type);
            osg::StateSet& stateSet = *quad->getOrCreateStateSet();
            if (i == 0) stateSet.setAttributeAndModes(program);
            if (i == 0) stateSet.addUniform(new osg::Uniform("first", colour));
            if (i == 1) stateSet.setTextureAttributeAndModes(0, chequers);
            if (i == 2) stateSet.setAttributeAndModes(scissor);
            if (i == 3) stateSet.setAttribute(mask);
            if (i == 4) stateSet.setAttribute(viewport);
            if (i == 5) stateSet.setMode(GL_BLEND, osg::StateAttribute::ON);
            if (i == 6) stateSet.setAttribute(new osg::Depth(osg::Depth::LESS, 0, 1, bin % 2));
            if (i == 7) stateSet.setTextureAttributeAndModes(1, chequers);
            row->addChild(quad);
            motley->addChild(quad); // not under the row's state, too
        }
        osg::StateSet& shared = *row->getOrCreateStateSet();
        shared.setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE));
        shared.setMode(GL_LIGHTING, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
        shared.addUniform(new osg::Uniform("first", osg::Vec4(0.3, 0.7, 0.1 * bin, 1)),
                          osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
        shared.setTextureAttribute(0, new osg::TexEnv(osg::TexEnv::ADD));
        motley->addChild(row);
    }
    return motley;
}

osg::ref_ptr<osg::Camera> createHud()
{
    osg::ref_ptr<osg::Camera> hud = new osg::Camera;
    hud->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    hud->setProjectionMatrixAsOrtho2D(0, WIDTH, 0, HEIGHT);
    hud->setRenderOrder(osg::Camera::POST_RENDER);
    hud->setClearMask(GL_DEPTH_BUFFER_BIT);
    hud->addChild(scenes::createQuad(osg::Vec3(10, 10, 0), osg::Vec3(40, 0, 0), osg::Vec3(0, 20, 0),
                                     osg::Vec4(1, 1, 0, 1)));
    return hud;
}

// An image computed from a capture's colour.
struct Negative
{
    Negative() : stage(new ImageStage), camera(new osg::Camera), image(new osg::Texture2D)
    {
        image->setTextureSize(WIDTH, HEIGHT);
        image->setInternalFormat(GL_RGBA8);
        image->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
        image->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->setImplicitBufferAttachmentMask(0, 0);
        camera->attach(osg::Camera::COLOR_BUFFER0, image);
        stage->setCamera(camera);
        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(
            osg::Shader::VERTEX, "#version 130\nvoid main() { gl_Position = gl_Vertex; }"));
        program->addShader(
            new osg::Shader(osg::Shader::FRAGMENT,
                            "#version 130\nuniform sampler2D source;\nvoid main() { gl_FragColor = "
                            "vec4(1.0) - texelFetch(source, ivec2(gl_FragCoord.xy), 0); }"));
        stage->stateSet().setAttributeAndModes(program);
        stage->stateSet().addUniform(new osg::Uniform("source", 0));
    }
    osg::ref_ptr<ImageStage> stage;
    osg::ref_ptr<osg::Camera> camera;
    osg::ref_ptr<osg::Texture2D> image;
};

// Follows each copy with a negative of it, and shows that in the water's bin.
void showNegative(CopyFrame& copy)
{
    struct Shown
    {
        Negative negative;
        osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    };
    const auto all = std::make_shared<std::map<Capture*, Shown>>();
    const osg::ref_ptr<osg::Node> quad = scenes::createQuad(
        osg::Vec3(-4, -5.9, 2.5), osg::Vec3(8, 0, 0), osg::Vec3(0, 0, 2), osg::Vec4(1, 1, 1, 1));
    quad->setCullingActive(false);
    copy.arranged = [all, quad](Capture& capture, osgUtil::CullVisitor& view)
    {
        Shown& shown = (*all)[&capture];
        shown.negative.stage->stateSet().setTextureAttribute(0, capture.colour);
        shown.negative.stage->prepare(0, 0, WIDTH, HEIGHT);
        capture.copy->stage().addPostRenderStage(shown.negative.stage);
        shown.stateSet->setTextureAttributeAndModes(0, shown.negative.image);
        shown.stateSet->setRenderBinDetails(9, "RenderBin");
        view.pushStateSet(shown.stateSet);
        quad->accept(view);
        view.popStateSet();
    };
}

} // namespace

// Breaks where Interlude does not push the StateSets again.
TEST_CASE("a frame goes on after its copy as if nothing had happened")
{
    CopiedView view;
    osg::ref_ptr<osg::Group> scene = createMotley();
    SECTION("in a window") {}
    SECTION("in a part of a window")
    {
        view.camera().setViewport(21, 13, 97, 75);
    }
    SECTION("with a head-up display")
    {
        scene->addChild(createHud());
        scene->insertChild(0, createHud());
    }
    SECTION("with all of it below one state set, and bins within a bin")
    {
        osg::ref_ptr<osg::Group> above = scenes::together({scene});
        above->getOrCreateStateSet()->setMode(GL_FOG, osg::StateAttribute::OFF);
        setBin(*above, 3);
        scene = scenes::together({above, scenes::createHarbour()});
    }
    SECTION("with nothing drawn before")
    {
        scene = scenes::together({createCurtain(9)});
    }
    SECTION("with a colour mask and a scissor box of the view's own")
    {
        view.camera().setColorMask(true, false, true, true);
        view.camera().setViewport(21, 13, 97, 75);
        scene = scenes::together({scenes::createHarbour(), createCurtain(9)});
        osg::ref_ptr<osg::Camera> wider = createHud();
        wider->setRenderOrder(osg::Camera::NESTED_RENDER);
        wider->setViewport(0, 0, WIDTH, HEIGHT);
        wider->getOrCreateStateSet()->setMode(GL_SCISSOR_TEST, osg::StateAttribute::ON);
        setBin(*wider, 9);
        scene->addChild(wider);
    }
    view.copy->origin = osg::Vec2i(11, 9);
    scene->insertChild(0, view.copier);
    view.copy->enabled = false;
    const osg::ref_ptr<osg::Image> without = copyOf(view.render(scene));
    CHECK(countDifferent(view.render(scene), *without) == 0);
    view.copy->enabled = true;
    for (int frame = 0; frame < 3; ++frame)
        CHECK(countDifferent(view.render(scene), *without) == 0);
    view.copy->enabled = false;
    CHECK(countDifferent(view.render(scene), *without) == 0);
}

namespace
{

// What OpenGL has now, of all that a scene may set.
struct GLState
{
    GLState()
    {
        for (GLenum what :
             {GL_DRAW_FRAMEBUFFER_BINDING_EXT, GL_READ_FRAMEBUFFER_BINDING_EXT, GL_VIEWPORT,
              GL_SCISSOR_BOX, GL_COLOR_WRITEMASK, GL_DEPTH_WRITEMASK, GL_DEPTH_FUNC, GL_BLEND_SRC,
              GL_BLEND_DST, GL_CURRENT_PROGRAM, GL_DRAW_BUFFER, GL_READ_BUFFER,
              GL_TEXTURE_BINDING_2D, GL_ACTIVE_TEXTURE, GL_POLYGON_MODE, GL_MATRIX_MODE})
        {
            GLint value[4] = {};
            glGetIntegerv(what, value);
            values[what].assign(value, value + 4);
        }
        for (GLenum what : {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_COLOR_CLEAR_VALUE})
        {
            GLdouble value[16] = {};
            glGetDoublev(what, value);
            values[what].assign(value, value + 16);
        }
        for (GLenum mode : {GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_LIGHTING,
                            GL_LIGHT0, GL_LIGHT1, GL_TEXTURE_2D, GL_NORMALIZE, GL_FOG})
            values[mode] = {double(glIsEnabled(mode))};
    }
    std::map<GLenum, std::vector<double>> values;
};

// Compares what OpenGL has before and after a copy, around the copy's own callback.
class CompareStates : public osgUtil::RenderBin::DrawCallback
{
public:
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& renderInfo,
                            osgUtil::RenderLeaf*& previous) override
    {
        osg::State& state = *renderInfo.getState();
        // As a stage does, behind the back of osg::State.
        glViewport(1, 2, 33, 44);
        glScissor(3, 4, 55, 66);
        glColorMask(GL_TRUE, GL_TRUE, GL_FALSE, GL_TRUE);
        const GLState before;
        const osg::State::StateSetStack stack = state.getStateSetStack();
        const osg::Matrixd initialView = state.getInitialViewMatrix();
        inner->drawImplementation(bin, renderInfo, previous);
        const GLState after;
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        for (const auto& value : before.values)
        {
            INFO("0x" << std::hex << value.first);
            CHECK(after.values.at(value.first) == value.second);
        }
        CHECK((state.getStateSetStack() == stack));
        CHECK((state.getInitialViewMatrix() == initialView));
        ++count;
    }
    osg::ref_ptr<osgUtil::RenderBin::DrawCallback> inner;
    int count = 0;
};

} // namespace

// Breaks where Interlude forgets anything.
TEST_CASE("a copy leaves OpenGL as it was")
{
    CopiedView view;
    SECTION("in a window") {}
    SECTION("in a part of a multisampled frame buffer object")
    {
        view.renderTo(GL_RGBA8, 4);
        view.camera().setViewport(21, 13, 97, 75);
    }
    const osg::ref_ptr<CompareStates> compare = new CompareStates;
    view.copy->arranged = [&](Capture&, osgUtil::CullVisitor& cull)
    {
        osgUtil::RenderBin& bin = *cull.getCurrentRenderStage()->find_or_insert(8, "RenderBin");
        compare->inner = bin.getDrawCallback();
        bin.setDrawCallback(compare);
    };
    const osg::ref_ptr<osg::Node> last = createCurtain(7);
    osg::StateSet& stateSet = *last->getOrCreateStateSet();
    stateSet.setAttributeAndModes(createProgram("first"));
    stateSet.setAttributeAndModes(new osg::Scissor(30, 20, 90, 70));
    stateSet.setAttributeAndModes(new osg::BlendFunc(GL_DST_COLOR, GL_ONE));
    stateSet.setAttributeAndModes(new osg::Depth(osg::Depth::GEQUAL, 0, 1, false));
    stateSet.setTextureAttributeAndModes(0, scenes::createChequers());
    stateSet.setAttributeAndModes(new osg::PolygonMode);
    stateSet.setAttribute(new osg::Viewport(10, 5, 120, 90));
    osg::ref_ptr<osg::Group> scene = scenes::together({view.copier, scenes::createHarbour(), last});
    for (int frame = 0; frame < 3; ++frame)
        view.render(scene);
    CHECK(compare->count == 3);
    compare->inner = nullptr;
}

// Breaks where Interlude does not bind the framebuffer again.
TEST_CASE("a frame in a multisampled frame buffer object goes on after its copy")
{
    CopiedView view;
    view.renderTo(GL_RGBA8, 4);
    osg::ref_ptr<osg::Texture2D> picture = dynamic_cast<osg::Texture2D*>(
        view.camera().getBufferAttachmentMap()[osg::Camera::COLOR_BUFFER0]._texture.get());
    const osg::ref_ptr<osg::Group> scene = scenes::together({view.copier, createMotley()});
    const auto render = [&]
    {
        view.render(scene);
        view.camera().getGraphicsContext()->makeCurrent();
        const osg::ref_ptr<osg::Image> image = readTexture(view.state(), *picture, GL_RGBA);
        view.camera().getGraphicsContext()->releaseContext();
        return image;
    };
    view.copy->enabled = false;
    const osg::ref_ptr<osg::Image> without = render();
    view.copy->enabled = true;
    for (int frame = 0; frame < 2; ++frame)
        CHECK(countDifferent(*render(), *without) == 0);
}

TEST_CASE("stages after a copy are drawn before the water")
{
    CopiedView view;
    showNegative(*view.copy);
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({view.copier, scenes::createHarbour(), createCurtain(10), view.reader});
    const osg::Image& picture = view.render(scene);
    // The quad covers the middle of the upper half with the whole of the negative, whose corners
    // are background.
    const osg::Vec4 clear = pixel(*view.reader->colour, 0, HEIGHT - 1);
    const osg::Vec4 expected = osg::Vec4(1, 1, 1, 1) - clear;
    int found = 0;
    for (int y = HEIGHT / 2; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            found += (pixel(picture, x, y) - expected).length() < 0.01;
    CHECK(found > 300);
}

TEST_CASE("each camera's frame is copied for itself, one before the other")
{
    CopiedView view;
    showNegative(*view.copy);
    const osg::ref_ptr<osg::Group> scene =
        scenes::together({view.copier, scenes::createHarbour(), createCurtain(10)});
    const osg::ref_ptr<osg::Image> alone = copyOf(view.render(scene));

    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(WIDTH, HEIGHT);
    texture->setInternalFormat(GL_RGBA8);
    osg::ref_ptr<osg::Camera> nested = new osg::Camera;
    nested->setRenderOrder(osg::Camera::PRE_RENDER);
    nested->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    nested->attach(osg::Camera::COLOR_BUFFER0, texture);
    nested->setViewport(0, 0, WIDTH, HEIGHT);
    nested->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    nested->setProjectionMatrix(view.camera().getProjectionMatrix());
    nested->setViewMatrix(view.camera().getViewMatrix());
    nested->setClearColor(view.camera().getClearColor());
    nested->addChild(scene);
    view.copy->captures.clear();
    const osg::ref_ptr<osg::Group> both = scenes::together({nested, scene});
    for (int frame = 0; frame < 2; ++frame)
        CHECK(countDifferent(view.render(both), *alone) == 0);
    CHECK(view.copy->captures.size() == 2);
    view.camera().getGraphicsContext()->makeCurrent();
    const osg::ref_ptr<osg::Image> image = readTexture(view.state(), *texture, GL_RGBA);
    view.camera().getGraphicsContext()->releaseContext();
    // Mesa keeps a window upside down, which rounds another way at edges.
    CHECK(countDifferent(*image, *alone, 1.01 / 255.0) < WIDTH * HEIGHT / 100);
}

TEST_CASE("a frame is copied while the next is culled")
{
    CopiedView alone;
    showNegative(*alone.copy);
    const osg::ref_ptr<osg::Group> motley = createMotley();
    motley->setDataVariance(osg::Object::STATIC);
    osg::ref_ptr<osg::Image> expected =
        copyOf(alone.render(scenes::together({alone.copier, motley})));

    const osg::ref_ptr<CopyFrame> copy = new CopyFrame;
    const osg::ref_ptr<osg::Group> copier = createCopier(*copy);
    showNegative(*copy);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(WIDTH, HEIGHT, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    osgViewer::Viewer viewer;
    osg::Camera& camera = *viewer.getCamera();
    camera.setGraphicsContext(osgWaterReflect::createOffscreenContext(WIDTH, HEIGHT).get());
    camera.setViewport(0, 0, WIDTH, HEIGHT);
    camera.setDrawBuffer(GL_FRONT);
    camera.setReadBuffer(GL_FRONT);
    camera.attach(osg::Camera::COLOR_BUFFER, image);
    camera.setViewMatrix(alone.camera().getViewMatrix());
    camera.setProjectionMatrix(alone.camera().getProjectionMatrix());
    viewer.setThreadingModel(osgViewer::ViewerBase::DrawThreadPerContext);
    viewer.setSceneData(scenes::together({copier, motley}));
    viewer.realize();
    for (int frame = 0; frame < 6; ++frame)
        viewer.frame(0.0);
    viewer.stopThreading();
    CHECK(copy->captures.size() == 2);
    CHECK(countDifferent(*image, *expected) == 0);
    viewer.setDone(true);
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
        const osg::ref_ptr<osg::Image> colour = view.copied(false);
        const osg::ref_ptr<osg::Image> windowZ = view.copied(true);
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
