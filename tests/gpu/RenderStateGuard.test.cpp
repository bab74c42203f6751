// What is drawn after a frame's copy, in the middle of its draw.

#include "support/Catch.h"
#include "support/CopiedView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/Scissor>
#include <osg/TexEnv>

#include <map>
#include <memory>
#include <vector>

using osgWaterReflect::ImageStage;

namespace
{

const int WIDTH = HarbourWindow::WIDTH;
const int HEIGHT = HarbourWindow::HEIGHT;

void setBin(osg::Node& node, int bin, const char* type = "RenderBin")
{
    node.getOrCreateStateSet()->setRenderBinDetails(bin, type);
}

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
    const osg::ref_ptr<osg::Program> program = createColourProgram("first");
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
    const auto all = std::make_shared<std::map<CopiedCapture*, Shown>>();
    const osg::ref_ptr<osg::Node> quad = scenes::createQuad(
        osg::Vec3(-4, -5.9, 2.5), osg::Vec3(8, 0, 0), osg::Vec3(0, 0, 2), osg::Vec4(1, 1, 1, 1));
    quad->setCullingActive(false);
    copy.arranged = [all, quad](CopiedCapture& capture, osgUtil::CullVisitor& view)
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

// Breaks where RenderStateGuard does not push the StateSets again.
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

// Breaks where RenderStateGuard forgets anything.
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
    view.copy->arranged = [&](CopiedCapture&, osgUtil::CullVisitor& cull)
    {
        osgUtil::RenderBin& bin = *cull.getCurrentRenderStage()->find_or_insert(8, "RenderBin");
        compare->inner = bin.getDrawCallback();
        bin.setDrawCallback(compare);
    };
    const osg::ref_ptr<osg::Node> last = createCurtain(7);
    osg::StateSet& stateSet = *last->getOrCreateStateSet();
    stateSet.setAttributeAndModes(createColourProgram("first"));
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

// Breaks where RenderStateGuard does not bind the framebuffer again.
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
        return view.read(*picture, GL_RGBA);
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
    const osg::ref_ptr<osg::Image> image = view.read(*texture, GL_RGBA);
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
