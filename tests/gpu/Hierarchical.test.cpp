// The pyramid of a capture, and the search that uses it.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osgUtil/RenderStage>
#include <osgViewer/Renderer>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace osgWaterReflect;
using DebugView = WaterSurface::DebugView;

namespace
{

osg::ref_ptr<WaterSurface> createWater(Search search)
{
    osg::ref_ptr<WaterSurface> water = scenes::createBoxesWater();
    ReflectionSettings settings;
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    settings.search = search;
    REQUIRE(water->setReflection(settings));
    return water;
}

// A texture that a stage rendered, or one after it, by the name of its camera; floats.
osg::ref_ptr<osg::Image> readPass(osgViewer::Viewer& viewer, osgUtil::RenderStage& stage,
                                  const std::string& cameraName)
{
    const osg::Camera* camera = stage.getCamera();
    if (!camera || camera->getName() != cameraName)
    {
        osg::ref_ptr<osg::Image> image;
        for (const auto& before : stage.getPreRenderList())
            if (!image) image = readPass(viewer, *before.second, cameraName);
        for (const auto& after : stage.getPostRenderList())
            if (!image) image = readPass(viewer, *after.second, cameraName);
        return image;
    }
    const auto& attachments = camera->getBufferAttachmentMap();
    auto* texture = dynamic_cast<osg::Texture2D*>(attachments.begin()->second._texture.get());
    REQUIRE(texture);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texture->getTextureWidth(), texture->getTextureHeight(), 1, GL_RGBA,
                         GL_FLOAT);
    osg::GraphicsContext& context = *viewer.getCamera()->getGraphicsContext();
    context.makeCurrent();
    context.getState()->applyTextureAttribute(0, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, image->data());
    return lowerLeftPart(*image, camera->getViewport()->width(), camera->getViewport()->height());
}

osg::ref_ptr<osg::Image> readPass(osgViewer::Viewer& viewer, const std::string& cameraName)
{
    auto* renderer = dynamic_cast<osgViewer::Renderer*>(viewer.getCamera()->getRenderer());
    REQUIRE(renderer);
    return readPass(viewer, *renderer->getSceneView(0)->getRenderStage(), cameraName);
}

// Two steps of a 24-bit depth buffer, for what it holds is read back and fetched in two ways.
const float DEPTH_STEPS = 1.2e-7f;

bool differs(float a, float b)
{
    return std::abs(a - b) > DEPTH_STEPS;
}

// Nearest (farthest) windowZ in the cells of a side.
class Bounds
{
public:
    Bounds(const osg::Image& windowZ, int side, bool nearest) :
        _side(side), _columns((windowZ.s() + side - 1) / side),
        _bounds(_columns * ((windowZ.t() + side - 1) / side), nearest ? 1.0f : 0.0f)
    {
        for (int y = 0; y < windowZ.t(); ++y)
            for (int x = 0; x < windowZ.s(); ++x)
            {
                const float z = *reinterpret_cast<const float*>(windowZ.data(x, y));
                float& bound = _bounds[indexOf(x, y)];
                bound = nearest ? std::min(bound, z) : std::max(bound, z);
            }
    }
    float about(int x, int y) const { return _bounds[indexOf(x, y)]; }

private:
    std::size_t indexOf(int x, int y) const { return y / _side * _columns + x / _side; }

    int _side;
    int _columns;
    std::vector<float> _bounds;
};

} // namespace

// Falls when a cell leaves out a pixel at its border or at the image's, when a level is merged of
// the wrong cells, or when the pyramid is that of another frame.
TEST_CASE("a pyramid bounds what a capture shows, at any size")
{
    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
    scene->addChild(createWater(Search::HIERARCHICAL));
    const std::pair<int, int> sizes[] = {{1, 1},     {3, 2},     {4, 4},    {5, 33},   {31, 257},
                                         {257, 131}, {640, 480}, {1021, 7}, {4096, 9}, {9, 4096}};
    for (const auto& size : sizes)
    {
        INFO(size.first << " x " << size.second);
        OffscreenView view(size.first, size.second);
        view.look(osg::Vec3d(0, -4, 2), osg::Vec3d(0, 20, 1));
        const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
        view.render(scene);
        view.look(osg::Vec3d(1, -3, 2.5), osg::Vec3d(0, 20, 1));
        view.render(scene);
        const osg::Image& windowZ = *captured->one().windowZ;
        const osg::ref_ptr<osg::Image> cells =
            readPass(view.viewer(), "osgWaterReflect pyramid_pack.frag");
        REQUIRE(cells);
        CHECK(windowZ.s() >= size.first); // and a guard band, in a part of larger textures
        CHECK(windowZ.t() >= size.second);
        CHECK(cells->s() == (windowZ.s() + 3) / 4);
        CHECK(cells->t() == (windowZ.t() + 3) / 4);

        const Bounds small(windowZ, 4, true);
        const Bounds middle(windowZ, 32, true);
        const Bounds large(windowZ, 256, true);
        const Bounds farthest(windowZ, 4, false);
        int wrong = 0;
        for (int y = 0; y < cells->t(); ++y)
            for (int x = 0; x < cells->s(); ++x)
            {
                const osg::Vec4 cell = cells->getColor(x, y);
                wrong += differs(cell.r(), small.about(4 * x, 4 * y)) ||
                         differs(cell.g(), middle.about(4 * x, 4 * y)) ||
                         differs(cell.b(), large.about(4 * x, 4 * y)) ||
                         differs(cell.a(), farthest.about(4 * x, 4 * y));
            }
        CHECK(wrong == 0);
    }
}

// Falls when the pyramid is built for every search.
TEST_CASE("no pyramid is built where no search uses it")
{
    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
    const osg::ref_ptr<WaterSurface> water = createWater(Search::SEQUENTIAL);
    scene->addChild(water);
    OffscreenView view(64, 48);
    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    view.render(scene);
    CHECK(captured->stages == 2); // the capture and its sky
    scene->addChild(createWater(Search::HIERARCHICAL));
    scene->addChild(createWater(Search::HIERARCHICAL));
    view.render(scene);
    CHECK(captured->stages == 6); // and four passes, for both
}

// Falls when a cell is left too late or too early, when a ray that is behind something is taken for
// one in front, or when the column before a hit is forgotten.
TEST_CASE("the hierarchical search finds what the sequential search finds, in few fetches")
{
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.15);
    for (const bool branch : {false, true})
        for (const bool moving : {false, true})
            for (const double pitchDegrees : {0.0, 8.6, 30.0})
                for (const double rollDegrees : {0.0, 70.0})
                {
                    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
                    if (branch)
                        scene->addChild(scenes::createBox(osg::Vec3(0, 1.5, 2.85),
                                                          osg::Vec3(4, 1, 0.3),
                                                          osg::Vec4(0.3, 0.2, 0.1, 1)));
                    const osg::ref_ptr<WaterSurface> water = createWater(Search::SEQUENTIAL);
                    scene->addChild(water);
                    if (moving) water->setWaves(breeze);
                    water->setDebugView(DebugView::HIT);

                    OffscreenView view(333, 241, OffscreenView::Format::RGBA32F);
                    view.camera().setClearColor(osg::Vec4(0, 0, 0, -9));
                    const double pitch = osg::DegreesToRadians(pitchDegrees);
                    const osg::Vec3d eye(0, -4, 2);
                    view.look(eye, eye + osg::Vec3d(0, std::cos(pitch), -std::sin(pitch)));
                    view.camera().setViewMatrix(
                        view.camera().getViewMatrix() *
                        osg::Matrixd::rotate(osg::DegreesToRadians(rollDegrees),
                                             osg::Vec3d(0, 0, 1)));
                    const osg::ref_ptr<osg::Image> sequential = copyOf(view.render(scene));
                    ReflectionSettings settings = water->getReflection();
                    settings.search = Search::HIERARCHICAL;
                    REQUIRE(water->setReflection(settings));
                    const osg::ref_ptr<osg::Image> hierarchical = copyOf(view.render(scene));

                    int pixels = 0;
                    int different = 0;
                    double fetchesSequential = 0.0;
                    double fetchesHierarchical = 0.0;
                    for (int y = 0; y < view.height(); ++y)
                        for (int x = 0; x < view.width(); ++x)
                        {
                            const osg::Vec4 a = pixel(*sequential, x, y);
                            const osg::Vec4 b = pixel(*hierarchical, x, y);
                            if (a.a() <= 1.0f) continue; // no water, or nothing searched
                            ++pixels;
                            fetchesSequential += a.a();
                            fetchesHierarchical += b.a();
                            different +=
                                a.z() != b.z() || std::hypot(a.x() - b.x(), a.y() - b.y()) > 1e-3;
                        }
                    INFO("branch " << branch << ", moving " << moving << ", pitch " << pitchDegrees
                                   << ", roll " << rollDegrees);
                    WARN(pixels << " pixels, " << different << " different; fetches "
                                << fetchesSequential / pixels << " and "
                                << fetchesHierarchical / pixels);
                    CHECK(pixels > 20000);
                    CHECK(different <= 1e-4 * pixels);
                    CHECK(fetchesHierarchical < 0.5 * fetchesSequential);
                }
}
