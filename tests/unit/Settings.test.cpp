// Each case falls when the check that it names is dropped from check(), or set...() assigns before
// it checks.

#include "support/Catch.h"
#include "support/Refusals.h"
#include "support/WaterAccess.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <limits>

using namespace osgWaterReflect;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double INF = std::numeric_limits<double>::infinity();
const double TINY = std::numeric_limits<double>::denorm_min();

osg::ref_ptr<WaterSurface> someWater()
{
    osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(1, 2, 3), osg::Vec3(10, 0, 0), osg::Vec3(0, 10, 0));
    REQUIRE(water);
    return water;
}

// Every value is tried as a member of a set of options: all bad ones are refused by the member's
// name with the old options kept, all good ones are taken without a word.
template <typename Options, typename Member>
void checkMember(const std::string& name, Member Options::*member, const std::vector<Member>& bad,
                 const std::vector<Member>& good)
{
    osg::ref_ptr<WaterSurface> water = someWater();
    Refusals refusals;
    for (const Member& value : bad)
    {
        const Options before = getSettings<Options>(*water);
        Options options = before;
        options.*member = value;
        CHECK_FALSE(setSettings(*water, options));
        const std::string message = refusals.take();
        INFO(message);
        CHECK(isRefusalOf(name, message));
        CHECK(getSettings<Options>(*water) == before);
    }
    for (const Member& value : good)
    {
        Options options = getSettings<Options>(*water);
        options.*member = value;
        CHECK(setSettings(*water, options));
        CHECK(refusals.take().empty());
        CHECK(getSettings<Options>(*water).*member == value);
    }
}

} // namespace

TEST_CASE("reflection settings out of range are refused, by name, and the old ones stay")
{
    checkMember<ReflectionSettings, Search>(
        "ReflectionSettings::search", &ReflectionSettings::search,
        {static_cast<Search>(0), static_cast<Search>(5), static_cast<Search>(-1)},
        {Search::BINARY, Search::SEQUENTIAL, Search::HIERARCHICAL, Search::AUTOMATIC});
    checkMember<ReflectionSettings, CaptureKind>(
        "ReflectionSettings::capture", &ReflectionSettings::capture,
        {static_cast<CaptureKind>(0), static_cast<CaptureKind>(6), static_cast<CaptureKind>(-1)},
        {CaptureKind::VIEW, CaptureKind::FRAME, CaptureKind::MIRROR, CaptureKind::VIEW_AND_MIRROR,
         CaptureKind::AUTOMATIC});
    checkMember<ReflectionSettings, double>("ReflectionSettings::thickness",
                                            &ReflectionSettings::thickness,
                                            {0.0, -0.0, -0.5, NaN, INF, -INF}, {TINY, 0.001, 1e6});
    checkMember<ReflectionSettings, int>(
        "ReflectionSettings::stride", &ReflectionSettings::stride,
        {0, -1, 65, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}, {1, 64});
}

TEST_CASE("view settings out of range are refused, by name, and the old ones stay")
{
    checkMember<ViewSettings, double>("ViewSettings::captureScale", &ViewSettings::captureScale,
                                      {0.0, -1.0, 1.0000001, NaN, INF, -INF}, {TINY, 0.5, 1.0});
    checkMember<ViewSettings, GuardBandKind>(
        "ViewSettings::guardBand", &ViewSettings::guardBand,
        {static_cast<GuardBandKind>(0), static_cast<GuardBandKind>(4),
         static_cast<GuardBandKind>(-1)},
        {GuardBandKind::NONE, GuardBandKind::FIXED, GuardBandKind::ADAPTIVE});
    checkMember<ViewSettings, double>("ViewSettings::maxExtraPixels", &ViewSettings::maxExtraPixels,
                                      {-TINY, -1.0, 3.0001, NaN, INF, -INF}, {0.0, TINY, 3.0});
    checkMember<ViewSettings, double>("ViewSettings::guardBandShare", &ViewSettings::guardBandShare,
                                      {-TINY, -1.0, 1.0001, NaN, INF, -INF}, {0.0, TINY, 1.0});
    checkMember<ViewSettings, double>("ViewSettings::traceScale", &ViewSettings::traceScale,
                                      {0.0, -1.0, 1.0000001, NaN, INF, -INF}, {TINY, 0.5, 1.0});
    checkMember<ViewSettings, double>("ViewSettings::frameTimeTarget",
                                      &ViewSettings::frameTimeTarget, {-TINY, -1.0, NaN, INF, -INF},
                                      {0.0, TINY, 16.7, 1e9});
}

TEST_CASE("optics out of range are refused, by name, and the old ones stay")
{
    checkMember<WaterOptics, double>("WaterOptics::refractiveIndex", &WaterOptics::refractiveIndex,
                                     {0.0, 0.999, 4.001, -1.333, NaN, INF, -INF},
                                     {1.0, 1.333, 4.0});
    std::vector<osg::Vec3> bad;
    for (int i = 0; i < 3; ++i)
        for (double value : {-0.001, 1.001, NaN, INF, -INF})
        {
            osg::Vec3 colour(0.5f, 0.5f, 0.5f);
            colour[i] = value;
            bad.push_back(colour);
        }
    checkMember<WaterOptics, osg::Vec3>("WaterOptics::waterColour", &WaterOptics::waterColour, bad,
                                        {osg::Vec3(0, 0, 0), osg::Vec3(1, 1, 1)});
}

TEST_CASE("surface detail out of range is refused, by name, and the old one stays")
{
    checkMember<SurfaceDetail, double>("SurfaceDetail::maxEdgePixels",
                                       &SurfaceDetail::maxEdgePixels,
                                       {0.0, 0.999, 1024.1, -16.0, NaN, INF, -INF}, {1.0, 1024.0});
    checkMember<SurfaceDetail, double>("SurfaceDetail::maxErrorPixels",
                                       &SurfaceDetail::maxErrorPixels,
                                       {0.0, -0.5, 64.1, NaN, INF, -INF}, {TINY, 0.5, 64.0});
    checkMember<SurfaceDetail, unsigned int>(
        "SurfaceDetail::maxVertices", &SurfaceDetail::maxVertices,
        {0u, 999u, 10000001u, std::numeric_limits<unsigned int>::max()}, {1000u, 10000000u});
}

// Falls when the copy constructor leaves out any one member.
TEST_CASE("a copy of a water surface has the waves, sky, view and shape of the original")
{
    osg::ref_ptr<WaterSurface> water = someWater();
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.3);
    water->setWaves(waves);
    water->setSky(new osg::TextureCubeMap);
    water->setDebugView(WaterSurface::DebugView::REASON);
    water->setName("lake");

    osg::ref_ptr<WaterSurface> shallow =
        static_cast<WaterSurface*>(water->clone(osg::CopyOp::SHALLOW_COPY));
    CHECK(shallow->getWaves() == waves);
    CHECK(shallow->getSky() == water->getSky());
    osg::ref_ptr<WaterSurface> deep =
        static_cast<WaterSurface*>(water->clone(osg::CopyOp::DEEP_COPY_ALL));
    REQUIRE(deep->getWaves());
    CHECK(deep->getWaves() != waves);
    CHECK(deep->getWaves()->getHeight(osg::Vec2d(1, 2), 3.0) ==
          waves->getHeight(osg::Vec2d(1, 2), 3.0));
    REQUIRE(deep->getSky());
    CHECK(deep->getSky() != water->getSky());
    for (const WaterSurface* copy : {shallow.get(), deep.get()})
    {
        CHECK(copy->getDebugView() == WaterSurface::DebugView::REASON);
        CHECK(copy->getName() == "lake");
        CHECK(copy->getNumDrawables() == 1);
        CHECK(copy->getBound().center() == water->getBound().center());
        CHECK(copy->getBound().radius() == water->getBound().radius());
    }
}
