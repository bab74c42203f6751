// Water that only its waves bring into view, as a stock viewer draws it.

#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <osg/Geometry>
#include <osgUtil/RenderStage>
#include <osgViewer/Renderer>

#include <cmath>

using namespace osgWaterReflect;

namespace
{

int countWater(const osg::Image& image)
{
    int count = 0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            count += pixel(image, x, y).r() > 0.5f;
    return count;
}

// Boxes over water that moves, seen from a bank; of the water the reflection alone.
class Bank
{
public:
    explicit Bank(double maxErrorPixels) : _view(320, 240), _water(scenes::createBoxesWater())
    {
        _water->setWaves(TrochoidalWaves::createBreeze(3.0, 0.3));
        _water->setDebugView(WaterSurface::DebugView::REFLECTION);
        SurfaceDetail detail;
        detail.maxErrorPixels = maxErrorPixels;
        detail.maxVertices = 10000000;
        REQUIRE(_water->setDetail(detail));
        _root->addChild(scenes::createBoxes());
        _root->addChild(_water);
        _view.camera().setClearColor(osg::Vec4(0.5, 0.6, 0.8, 1));
    }

    osg::ref_ptr<osg::Image> renderFrom(const osg::Vec3d& eye)
    {
        _view.look(eye, eye + osg::Vec3d(0, 10, -2));
        return copyOf(_view.render(_root, 1.0));
    }

private:
    OffscreenView _view;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    osg::ref_ptr<WaterSurface> _water;
};

// [1] Mean over all pixels and colours.
double meanDifference(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
            for (int i = 0; i < 3; ++i)
                sum += std::abs(pixel(a, x, y)[i] - pixel(b, x, y)[i]);
    return sum / (3.0 * a.s() * a.t());
}

const osg::Vec3d BANK(0, 0, 1.7);

} // namespace

// Falls when WaterSurface::traverse asks isCulled(sheet->localBound(0.0)), computeBound leaves out
// the waves, or the mesh's `outside` knows no reach.
TEST_CASE("a crest that rises into the view is drawn, though the still water is below it")
{
    // A trough at the eye, 20 m long waves: the next crest stands 1.2 m high 10 m away.
    TrochoidalWave wave;
    wave.amplitude = 1.0;
    wave.length = 20.0;
    wave.directionDegrees = 90.0;
    wave.phase = osg::PI;
    osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves({wave}));
    osg::ref_ptr<WaterSurface> water = scenes::inView(WaterSurface::createRectangle(
        osg::Vec3(0, 32, 0), osg::Vec3(60, 0, 0), osg::Vec3(0, 60, 0)));
    WaterOptics optics;
    optics.waterColour.set(1, 0, 0);
    REQUIRE(water->setOptics(optics));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(water);

    OffscreenView view(160, 120);
    view.camera().setClearColor(osg::Vec4(0, 0, 0, 1));
    // 24 degrees up at half a field of view of 23: the lowest line of sight climbs by 1 degree
    // from 0.3 m over the still water, and passes the crest 0.7 m below its top.
    const osg::Vec3d eye(0, 0, 0.3);
    const double pitch = 24.0 * osg::PI / 180.0;
    view.look(eye, eye + osg::Vec3d(0, std::cos(pitch), std::sin(pitch)));
    CHECK(countWater(view.render(root)) == 0); // calm

    water->setWaves(waves);
    const osg::Image& image = view.render(root);
    keep(image, "crest");
    // The crest stands 3.4 degrees over the border, 9 rows; steep reflections take some of them.
    CHECK(countWater(image) > 100);
}

// Measured: 580 of 76,800 pixels differ by more than 8 of 255 from those of a mesh of six times as
// many vertices; with the error eight times as large, 2266. Falls when maxErrorPixels is 4 by
// default.
TEST_CASE("the mesh shows what a much finer one does")
{
    const osg::ref_ptr<osg::Image> fine = Bank(0.001).renderFrom(BANK);
    const osg::ref_ptr<osg::Image> image = Bank(SurfaceDetail().maxErrorPixels).renderFrom(BANK);
    keep(*fine, "bank-fine");
    keep(*image, "bank");
    CHECK(countDifferent(*fine, *image, 8.5 / 255.0) < 800);
    CHECK(meanDifference(*fine, *image) < 0.6 / 255.0);
}

// Neighbouring frames differ by 1.2 % more than with the finest mesh; with the error eight times as
// large by 3.7 %.
TEST_CASE("changes of the mesh do not show as the eye moves on")
{
    const auto change = [](double maxErrorPixels)
    {
        Bank bank(maxErrorPixels);
        osg::ref_ptr<osg::Image> last = bank.renderFrom(BANK);
        double sum = 0.0;
        for (int i = 1; i <= 40; ++i)
        {
            const osg::ref_ptr<osg::Image> now =
                bank.renderFrom(BANK + osg::Vec3d(0.006, 0.02, 0.0) * i);
            sum += meanDifference(*last, *now);
            last = now;
        }
        return sum;
    };
    CHECK(change(SurfaceDetail().maxErrorPixels) < 1.025 * change(0.02));
}

namespace
{

// What the water of a view was drawn with in the last frame: its leaf in the view's stage.
const osg::Drawable* drawnWater(osg::Camera& camera)
{
    auto& renderer = dynamic_cast<osgViewer::Renderer&>(*camera.getRenderer());
    const auto& bins = renderer.getSceneView(0)->getRenderStage()->getRenderBinList();
    const auto water = bins.find(9);
    REQUIRE(water != bins.end());
    const auto& graphs = water->second->getStateGraphList();
    REQUIRE(graphs.size() == 1);
    REQUIRE(graphs.front()->_leaves.size() == 1);
    return graphs.front()->_leaves.front()->getDrawable();
}

} // namespace

// Breaks where setWaves leaves the sheets to be taken from the drawables anew; and, for the second,
// where it keeps them though a drawable has changed since.
TEST_CASE("other waves keep the water's sheets and mesh, another outline does not")
{
    OffscreenView view(64, 48);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.1);
    lake->setWaves(waves);
    view.render(lake);
    const osg::Drawable* const mesh = drawnWater(view.camera());
    double radius = lake->getBound().radius();
    for (int i = 0; i < 5; ++i)
    {
        std::vector<osgWaterReflect::TrochoidalWave> higher = waves->getWaves();
        for (osgWaterReflect::TrochoidalWave& wave : higher)
            wave.amplitude *= 1.1;
        REQUIRE(waves->setWaves(higher));
        lake->setWaves(waves);
        CHECK(lake->getBoundingBox().zMax() >= static_cast<float>(waves->getAmplitude()));
        CHECK(lake->getBound().radius() >= radius);
        radius = lake->getBound().radius();
        view.render(lake);
        CHECK(drawnWater(view.camera()) == mesh);
    }

    auto& geometry = dynamic_cast<osg::Geometry&>(*lake->getDrawable(0));
    auto& corners = static_cast<osg::Vec3Array&>(*geometry.getVertexArray());
    lake->setWaves(waves);
    for (osg::Vec3& corner : corners)
        corner *= 2.0f;
    geometry.dirtyBound();
    view.render(lake);
    CHECK(drawnWater(view.camera()) != mesh);
    CHECK(lake->getBound().radius() > 1.5 * radius);
}
