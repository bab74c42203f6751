// What water is drawn with where its settings leave that to the view.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/view/FramePace.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

using namespace osgWaterReflect;

namespace
{

osg::ref_ptr<WaterSurface> createPond(const osg::Vec3& centre, double size)
{
    return WaterSurface::createRectangle(centre, osg::Vec3(size, 0, 0), osg::Vec3(0, size, 0));
}

// Looks at boxes in a lake.
struct BoxesView : OffscreenView
{
    BoxesView() :
        OffscreenView(160, 120, Format::RGBA32F), captured(CapturedImages::of(camera())),
        lake(createPond(osg::Vec3(0, 20, 0), 200.0)),
        scene(scenes::together({scenes::createBoxes(), lake}))
    {
        turn(8.6);
    }

    // Along +y, turned to the right.
    void turn(double pitchDegrees, double yawDegrees = 0.0)
    {
        const double pitch = osg::DegreesToRadians(pitchDegrees);
        const double yaw = osg::DegreesToRadians(yawDegrees);
        const osg::Vec3d eye(0.0137, -2, 2);
        look(eye, eye + osg::Vec3d(std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch),
                                   -std::sin(pitch)));
    }

    // "v" for each capture of the view's eye in the last frame, "m" for each of a mirrored one.
    std::string lastKinds() const
    {
        std::string kinds;
        for (const CapturedImage& image : captured->images)
            kinds += image.mirrored ? 'm' : 'v';
        std::sort(kinds.rbegin(), kinds.rend());
        return kinds;
    }

    std::string kinds()
    {
        render(scene);
        return lastKinds();
    }

    osg::ref_ptr<CapturedImages> captured;
    osg::ref_ptr<WaterSurface> lake;
    osg::ref_ptr<osg::Group> scene;
};

// [1] Mean over all pixels of how much their colours differ.
double meanDifference(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const osg::Vec4 difference = pixel(a, x, y) - pixel(b, x, y);
            sum += std::abs(difference.r()) + std::abs(difference.g()) + std::abs(difference.b());
        }
    return sum / (3.0 * a.s() * a.t());
}

// The largest difference of neighbouring frames where the captures change, over the largest
// elsewhere.
//   turn  to a place in [0, 1]
template <typename Turn>
double jump(BoxesView& view, const Turn& turn)
{
    const int steps = 200;
    double atSwitch = 0.0;
    double elsewhere = 0.0;
    std::string before;
    osg::ref_ptr<osg::Image> last;
    for (int i = 0; i <= steps; ++i)
    {
        turn(i / double(steps));
        const osg::ref_ptr<osg::Image> picture = copyOf(view.render(view.scene));
        const std::string kinds = view.lastKinds();
        if (last)
        {
            double& largest = kinds == before ? elsewhere : atSwitch;
            largest = std::max(largest, meanDifference(*last, *picture));
        }
        before = kinds;
        last = picture;
    }
    REQUIRE(atSwitch > 0.0);
    WARN("jumps by " << atSwitch << ", elsewhere by " << elsewhere << " at most");
    return atSwitch / elsewhere;
}

} // namespace

// Falls with the rules of settle(), and where SettledSettings looks at explicit settings.
TEST_CASE("a calm pond is captured by the mirrored eye only, ponds at two levels by the view's")
{
    BoxesView view;
    CHECK(view.kinds() == "m");
    CHECK(view.captured->stages ==
          7); // the capture, its straight windowZ, four of its cells, its sky

    // In the same plane, and at another level but behind the eye.
    view.scene->addChild(createPond(osg::Vec3(0, -30, 0), 20.0));
    view.scene->addChild(createPond(osg::Vec3(0, -80, 0.5), 20.0));
    CHECK(view.kinds() == "m");

    const osg::ref_ptr<WaterSurface> high = createPond(osg::Vec3(2, 8, 0.5), 2.0);
    view.scene->addChild(high);
    CHECK(view.kinds() == "v");

    // Explicit settings are left alone, and have no say.
    ReflectionSettings settings;
    settings.capture = CaptureKind::MIRROR;
    REQUIRE(high->setReflection(settings));
    CHECK(view.kinds() == "mm");
    view.scene->removeChild(high);
    CHECK(view.kinds() == "m");
}

// Falls with the rules of settle(), and where the view's capture does not say whether it serves.
TEST_CASE("waves are reflected in the view's capture, and where its band is too short in both")
{
    BoxesView view;
    view.lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.05));
    view.turn(0.0);
    CHECK(view.kinds() == "v");
    view.turn(45.0);
    CHECK(view.kinds() == "vm");
    view.scene->addChild(createPond(osg::Vec3(0.5, 0, 0.5), 2.0));
    CHECK(view.kinds() == "v");
    view.lake->setWaves(nullptr);
    view.scene->removeChildren(2, 1);
    CHECK(view.kinds() == "m");
}

// Falls when the plan asks for the rays of the steepest places, too.
TEST_CASE("a band that only the steepest places of waves leave serves")
{
    BoxesView view;
    view.scene->addChild(
        scenes::createBox(osg::Vec3(0, 0, 30), osg::Vec3(400, 400, 1), osg::Vec4(1, 1, 1, 1)));
    view.turn(2.0);
    const auto pixels = [&]
    {
        const osg::Image& image = *view.captured->images[0].windowZ;
        return image.s() * image.t();
    };

    view.lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.15));
    CHECK(view.kinds() == "v");
    CHECK(pixels() > 0.99 * 2 * 160 * 120); // the ceiling bites, whole pixels apart

    view.lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.3));
    CHECK(view.kinds() == "vm");
    CHECK(pixels() > 0.99 * 2 * 160 * 120);
}

// Falls where anything is decided by what the cull before has met.
TEST_CASE("a camera cut shows in its first frame what it shows in its second")
{
    BoxesView view;
    view.scene->addChild(createPond(osg::Vec3(30, -2, 0.5), 10.0)); // to the right
    const bool moving = GENERATE(false, true);
    view.lake->setWaves(moving ? TrochoidalWaves::createBreeze(2.0, 0.05) : nullptr);
    for (const osg::Vec2d& turned : {osg::Vec2d(8.6, 90), osg::Vec2d(8.6, 0), osg::Vec2d(45, 0),
                                     osg::Vec2d(45, 90), osg::Vec2d(0, 0)})
    {
        INFO("moving " << moving << ", turned " << turned.x() << ", " << turned.y());
        view.turn(turned.x(), turned.y());
        const osg::ref_ptr<osg::Image> first = copyOf(view.render(view.scene));
        CHECK(countDifferent(view.render(view.scene), *first) == 0);
    }
}

// The switch itself changes no more than the camera's own motion by a tenth of a degree does.
TEST_CASE("a camera that turns slowly past a switch of captures sees no jump")
{
    BoxesView view;
    SECTION("another pond comes into view")
    {
        view.scene->addChild(createPond(osg::Vec3(30, 8, 0.5), 10.0));
        CHECK(jump(view, [&](double at) { view.turn(8.6, 20.0 + 20.0 * at); }) <= 1.0);
    }
    SECTION("the band's ceiling begins to bite")
    {
        view.lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.05));
        CHECK(jump(view, [&](double at) { view.turn(30.0 + 15.0 * at); }) <= 1.0);
    }
}

// Falls without FramePace, and where its step is not what is drawn with.
TEST_CASE("frames that take too long make captures cheaper, and fast ones dearer again")
{
    BoxesView view;
    double now = 0.0;
    double load = 0.15; // [s] of a frame with a capture of the view's size
    int width = 160;    // [pixels] of the last capture
    const auto run = [&](int frames)
    {
        for (int i = 0; i < frames; ++i)
        {
            now += load * (width == 160 ? 1.0 : 0.6);
            view.render(view.scene);
            width = view.captured->images.front().colour->s();
        }
        return width;
    };
    FramePace::of(view.camera())->clock = [&] { return now; };
    CHECK(run(50) == 160); // no target

    ViewSettings settings;
    settings.frameTimeTarget = 100.0;
    REQUIRE(view.lake->setViewSettings(settings));
    // Two steps, a window of 15 frames and those in flight each. Half as large it takes 90 ms.
    CHECK(run(60) == 80);
    CHECK(run(60) == 80);
    load = 0.075;
    CHECK(run(240) == 160); // two steps, a wait of 4 s each
    load = 0.15;
    CHECK(run(60) == 80);
    settings.frameTimeTarget = 0.0;
    REQUIRE(view.lake->setViewSettings(settings));
    CHECK(run(1) == 160);
}

// Breaks where FramePace is kept in the camera's user data, which is written with the camera.
TEST_CASE("what paces a camera's frames is not part of the scene")
{
    BoxesView view;
    ViewSettings settings;
    settings.frameTimeTarget = 16.0;
    REQUIRE(view.lake->setViewSettings(settings));
    view.render(view.scene);
    const osg::UserDataContainer* const data = view.camera().getUserDataContainer();
    CHECK((!data || data->getNumUserObjects() == 0));
    CHECK(FramePace::of(view.camera()) == FramePace::of(view.camera()));
}

// Breaks where captures go with the frame that has no use for them: a choice that comes and goes
// would make textures anew each time.
TEST_CASE("a choice that comes and goes keeps its textures, and one that has gone gives them back")
{
    double now = 0.0;
    BoxesView view;
    view.record().clock = [&now] { return now; };
    std::set<osg::ref_ptr<osg::Texture>> textures;
    const osg::ref_ptr<WaterSurface> high = createPond(osg::Vec3(2, 8, 0.5), 2.0);
    for (int i = 0; i < 20; ++i)
    {
        now += 1.0 / 60.0;
        if (i % 2)
            view.scene->addChild(high);
        else
            view.scene->removeChild(high);
        CHECK(view.kinds() == (i % 2 ? "v" : "m"));
        for (const auto& texture : view.captured->textures)
            textures.insert(texture.get());
    }
    CHECK(textures.size() == 5); // colour and windowZ of both, and one of them straightened
    CHECK(view.record().numCaptures() == 2);
    now += 1.1 * WaterView::HOLD_TIME;
    CHECK(view.kinds() == "v");
    CHECK(view.record().numCaptures() == 1);
}

// Breaks where a status is not told of each sheet and view, or tells of an image that is not taken.
TEST_CASE("water tells what its last frame did, and why not more")
{
    BoxesView view;
    CHECK(view.lake->getStatus().empty());
    view.render(view.scene);
    std::vector<WaterStatus> status = view.lake->getStatus();
    REQUIRE(status.size() == 1);
    CHECK(status[0].camera == &view.camera());
    REQUIRE(status[0].images.size() == 1);
    CHECK(status[0].images[0].kind == CaptureKind::MIRROR);
    CHECK(status[0].images[0].width == 160);
    CHECK(status[0].passes == static_cast<int>(view.captured->stages));
    CHECK(status[0].program.find("water.frag") != std::string::npos);

    view.lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.05));
    view.turn(45.0);
    view.render(view.scene);
    status = view.lake->getStatus();
    REQUIRE(status.size() == 1);
    REQUIRE(status[0].images.size() == 2);
    CHECK(status[0].images[0].kind == CaptureKind::VIEW);
    CHECK(status[0].images[0].height > 120);
    CHECK(status[0].images[1].kind == CaptureKind::MIRROR);
    CHECK(status[0].passes == static_cast<int>(view.captured->stages));
    std::ostringstream text;
    text << status[0];
    CHECK(text.str().find("drawn from the mirrored eye, 160 x 120") != std::string::npos);
    CHECK(text.str().find("guard band: yes") != std::string::npos);
}
