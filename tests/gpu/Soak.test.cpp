// Whole frames under abuse: a camera that goes anywhere, an image of any size, waters that come and
// go, tilt and shrink to nothing, settings that change from frame to frame.

#include "support/AnySettings.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>

#include <osg/MatrixTransform>

#include <malloc.h>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

class Abuse
{
public:
    static constexpr std::size_t WATERS = 3;

    explicit Abuse(unsigned int seed) : _chance(seed), _scene(new osg::Group)
    {
        _scene->addChild(scenes::createHarbour());
        for (std::size_t i = 0; i < WATERS; ++i)
        {
            const osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform;
            _places.push_back(place);
            _scene->addChild(place);
            replaceWater(*place);
        }
    }

    osg::Node* scene() { return _scene; }
    double time() const { return _time; }

    // Changes some of everything.
    void step(OffscreenView& view)
    {
        aim(view.camera());
        if (view.width() > 1024 || _chance.once(20)) resize(view);
        if (_chance.once(2)) _time = _chance.logBetween(1e-3, 1e9);
        osg::MatrixTransform& place = *_places[_chance.integer(0, static_cast<int>(WATERS) - 1)];
        switch (_chance.integer(0, 5))
        {
        case 0:
            place.setNodeMask(place.getNodeMask() ? 0u : ~0u);
            break;
        case 1:
            replaceWater(place);
            break;
        case 2:
            tilt(place);
            break;
        case 3:
            change(*water(place));
            break;
        case 4:
            roughen(*water(place));
            break;
        default:
            break;
        }
        for (const auto& each : _places)
            watch(*water(*each));
    }

private:
    static WaterSurface* water(osg::MatrixTransform& place)
    {
        return static_cast<WaterSurface*>(place.getChild(0));
    }

    void aim(osg::Camera& camera)
    {
        osg::Vec3d eye(_chance.between(-20, 20), _chance.between(-20, 20), _chance.between(-3, 12));
        if (_chance.once(4)) eye.z() = _chance.logBetween(1e-9, 0.3) * (_chance.once(2) ? 1 : -1);
        if (_chance.once(16)) eye.z() = 0.0; // level with the water
        if (_chance.once(16)) eye *= 1e5;
        const osg::Vec3d centre =
            _chance.once(2) ? osg::Vec3d(0, 0, 0.5) : eye + _chance.direction();
        camera.setViewMatrixAsLookAt(eye, centre, _chance.direction());
        const osg::Viewport& viewport = *camera.getViewport();
        const double aspect = viewport.width() / std::max(viewport.height(), 1.0);
        if (_chance.once(6))
        {
            const double side = _chance.logBetween(1e-3, 1e3);
            camera.setProjectionMatrixAsOrtho(-side, side, -side, side, -100.0, 100.0);
        }
        else
            camera.setProjectionMatrixAsPerspective(
                _chance.once(2) ? 46.0 : _chance.logBetween(0.1, 179.0), std::max(aspect, 1e-3),
                0.1, 1000.0);
    }

    void resize(OffscreenView& view)
    {
        if (_chance.once(25)) // of 500 frames one in the mean, for they take long
            return view.resize(4096, 3);
        if (_chance.once(10)) return view.resize(0, 0);
        view.resize(_chance.integer(1, 80), _chance.integer(1, 60));
    }

    void replaceWater(osg::MatrixTransform& place)
    {
        const double side =
            _chance.once(4) ? _chance.logBetween(1e-6, 1e6) : _chance.between(5.0, 60.0);
        const osg::ref_ptr<WaterSurface> water = WaterSurface::createRectangle(
            osg::Vec3(_chance.between(-5, 5), 0, 0), osg::Vec3(side, 0, 0), osg::Vec3(0, side, 0));
        REQUIRE(water);
        change(*water);
        roughen(*water);
        place.removeChildren(0, place.getNumChildren());
        place.addChild(water);
    }

    void tilt(osg::MatrixTransform& place)
    {
        osg::Matrixd matrix; // level again
        if (_chance.once(2))
            matrix = osg::Matrixd::rotate(_chance.between(-osg::PI, osg::PI), _chance.direction());
        if (_chance.once(6)) matrix = osg::Matrixd::rotate(osg::PI_2, osg::Vec3d(1, 0, 0));
        if (_chance.once(6)) matrix = osg::Matrixd::rotate(osg::PI, osg::Vec3d(1, 0, 0));
        if (_chance.once(6)) matrix.preMult(osg::Matrixd::scale(1.0, 1.0, -1.0));
        if (_chance.once(6)) matrix.preMult(osg::Matrixd::scale(0.01, 100.0, 3.0));
        matrix.postMult(osg::Matrixd::translate(0, 0, _chance.once(2) ? 0.0 : 0.4));
        place.setMatrix(matrix);
    }

    void change(WaterSurface& water)
    {
        REQUIRE(water.setReflection(goodSettings<ReflectionSettings>(_chance)));
        REQUIRE(water.setViewSettings(goodSettings<ViewSettings>(_chance)));
        REQUIRE(water.setOptics(goodSettings<WaterOptics>(_chance)));
        auto detail = goodSettings<SurfaceDetail>(_chance);
        detail.maxVertices = std::min(detail.maxVertices, 3000u); // more would only take longer
        REQUIRE(water.setDetail(detail));
    }

    // Half of the frames show the water, half what its picture is made of.
    void watch(WaterSurface& water)
    {
        using DebugView = WaterSurface::DebugView;
        water.setDebugView(
            _chance.once(2)
                ? DebugView::NONE
                : _chance.oneOf({DebugView::HIT, DebugView::HIT, DebugView::POINT,
                                 DebugView::NORMAL, DebugView::REFLECTION, DebugView::REASON}));
    }

    void roughen(WaterSurface& water)
    {
        water.setWaves(_chance.once(3)
                           ? nullptr
                           : TrochoidalWaves::createBreeze(_chance.logBetween(1e-2, 1e3),
                                                           _chance.logBetween(1e-6, 0.999)));
    }

    Chance _chance;
    osg::ref_ptr<osg::Group> _scene;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _places;
    double _time = 0.0;
};

// [bytes] That the program holds.
double heldMemory()
{
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

// [bytes] That are held when all water has gone, and with the last of it its programs: how many
// variants of these there are depends on what was met.
double heldAtRest(OffscreenView& view)
{
    view.resize(48, 36);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<osg::Group> calm = scenes::together({scenes::createLake()});
    view.render(calm);
    calm->releaseGLObjects(view.camera().getGraphicsContext()->getState());
    const osg::ref_ptr<osg::Group> nothing = new osg::Group;
    for (int i = 0; i < 3; ++i)
        view.render(nothing);
    return heldMemory();
}

//   now  [s] of the view's clock
void abuseFor(OffscreenView& view, int round, int frames, double& now)
{
    Abuse abuse(round);
    for (int i = 0; i < frames; ++i)
    {
        now += 1.0 / 60.0;
        abuse.step(view);
        INFO("round " << round << ", frame " << i << ", " << view.width() << " x "
                      << view.height());
        CHECK(countNotFinite(view.render(abuse.scene(), abuse.time())) == 0);
        CHECK(view.record().numDraws() <= Abuse::WATERS);
    }
}

// In rounds, each with waters of its own, from one to the next of which nothing is kept.
void soak(int rounds, int framesEach)
{
    double now = 0.0;
    OffscreenView view(48, 36, OffscreenView::Format::RGBA32F);
    view.record().clock = [&now] { return now; };
    std::vector<double> held;
    for (int round = 1; round <= rounds; ++round)
    {
        abuseFor(view, round, framesEach, now);
        now += 2.0 * osgWaterReflect::WaterView::HOLD_TIME;
        held.push_back(heldAtRest(view));
    }
    const auto half = held.begin() + rounds / 2;
    const double early = *std::min_element(held.begin(), half);
    const double grown = *std::min_element(half, held.end()) - early;
    INFO(early << " bytes held in the first half, then " << grown << " more");
    // OSG itself remembers every size that a texture has had, in some 300 bytes.
    CHECK(grown < 2e6 + 300.0 * 0.5 * rounds * framesEach);
}

} // namespace

// Falls where colourAmidEdges divides by a sum of weights that is 0; where a WaveMesh holds its
// sheet; and where LowResTrace::begin does not reset its graph.
TEST_CASE("frames under abuse hold no NaN, raise no GL error and keep no memory")
{
    soak(10, 100);
}

TEST_CASE("a hundred thousand frames under abuse", "[.full]")
{
    soak(200, 500);
}
