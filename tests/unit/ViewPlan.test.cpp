// What is planned for the water of a view, and why, without drawing anything.

#include "support/Catch.h"
#include "support/ListedEffect.h"
#include "support/glass/Glass.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/view/ViewPlan.h>
#include <osgWaterReflect/water/WaterDraw.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cstring>
#include <map>

using namespace osgWaterReflect;

namespace
{

// A view of 320 x 240 pixels, from 6 m above, and the waters in it.
struct PlannedView
{
    explicit PlannedView(double pitchDegrees = 45.0) :
        eyeFromWorld(
            glm::rotate(glm::dmat4(1.0), glm::radians(pitchDegrees - 90.0), glm::dvec3(1, 0, 0)) *
            glm::translate(glm::dmat4(1.0), glm::dvec3(0, 12, -6)))
    {
        facts.clipFromEye = glm::perspective(glm::radians(45.0), 4.0 / 3.0, 0.1, 10000.0);
        facts.viewportSize = {320, 240};
        facts.viewport = {320.0, 240.0};
        facts.accuracyStep = [this](double, int numSteps) { return std::min(step, numSteps - 1); };
        facts.cullScene = [this](EyeImage image, const GuardBandRequest& request)
        {
            ++culls;
            culled = image;
            possible = request.possible();
            return sceneReach;
        };
    }

    WaterSurface& add(double level = 0.0, double steepness = 0.0)
    {
        const osg::ref_ptr<WaterSurface> water = WaterSurface::createRectangle(
            osg::Vec3(0, 0, level), osg::Vec3(400, 0, 0), osg::Vec3(0, 400, 0));
        if (steepness > 0.0) water->setWaves(TrochoidalWaves::createBreeze(2.0, steepness));
        VisibleSheet sheet;
        sheet.water = water;
        sheet.sheet = StillWater::createSheets(*water->getDrawable(0)).front();
        sheet.bounds = std::make_shared<WaveBounds>(water->getWaves());
        sheet.eyeFromSurface = eyeFromWorld * sheet.sheet->localFromSurface();
        sheets.push_back(sheet);
        return *water;
    }

    const ViewPlan& make()
    {
        culls = 0;
        makePlan(facts, plan);
        return plan;
    }

    CaptureKind kind(std::size_t i = 0) { return make().sheets[i].settings.capture; }

    const glm::dmat4 eyeFromWorld;
    std::vector<VisibleSheet> sheets;
    ViewFacts facts{sheets};
    ViewPlan plan;
    NdcExtent sceneReach = {-100, 100, -100, 100};
    int step = 0; // of accuracy that there is time for
    int culls = 0;
    EyeImage culled = EyeImage::NONE;
    NdcExtent possible;
};

template <typename Value>
void set(WaterSurface& water, Value ViewSettings::*member, Value value)
{
    ViewSettings settings = water.getViewSettings();
    settings.*member = value;
    REQUIRE(water.setViewSettings(settings));
}

void setCapture(WaterSurface& water, CaptureKind capture)
{
    ReflectionSettings settings = water.getReflection();
    settings.capture = capture;
    REQUIRE(water.setReflection(settings));
}

const WaterStatus::Decision& decision(const ViewPlan& plan, const char* subject, std::size_t i = 0)
{
    for (const WaterStatus::Decision& decision : plan.sheets[i].decisions)
        if (std::strcmp(decision.subject, subject) == 0) return decision;
    FAIL("no decision about " << subject);
    return plan.sheets[i].decisions.front();
}

} // namespace

// Breaks where the plan culls whatever it plans, or lets a mirrored image go where nothing serves.
TEST_CASE("a plan culls the scene once at most, and not where no image of the eye is drawn")
{
    PlannedView view;
    SECTION("calm water in one plane")
    {
        view.add();
        CHECK(view.kind() == CaptureKind::MIRROR);
        CHECK(view.culls == 0);
        CHECK(view.plan.eyeImage == EyeImage::NONE);
        CHECK(view.plan.mirrors.size() == 1);
    }
    SECTION("waves that no band serves")
    {
        view.add(0.0, 0.05);
        CHECK(view.kind() == CaptureKind::VIEW_AND_MIRROR);
        CHECK(view.culls == 1);
    }
    SECTION("waves where the scene ends with the view")
    {
        view.add(0.0, 0.05);
        view.sceneReach = NdcExtent();
        CHECK(view.kind() == CaptureKind::VIEW);
        CHECK(view.culls == 1);
        CHECK(view.plan.mirrors.empty());
    }
    SECTION("two planes")
    {
        view.add();
        view.add(0.5);
        CHECK(view.kind(1) == CaptureKind::VIEW);
        CHECK(view.culls == 1);
    }
}

// Breaks where serves() is asked only of bands that adapt, as the choice once was: then a band of
// nothing was said to serve, and one of nearly nothing was not.
TEST_CASE("no band, a closed one and nearly none lead to the same choice")
{
    for (const double pitch : {15.0, 30.0, 45.0})
    {
        std::map<CaptureKind, int> kinds;
        for (const double ceiling : {0.0, 1e-6, 0.001})
        {
            PlannedView view(pitch);
            set(view.add(0.0, 0.05), &ViewSettings::maxExtraPixels, ceiling);
            ++kinds[view.kind()];
        }
        for (const GuardBandKind kind : {GuardBandKind::NONE, GuardBandKind::FIXED})
        {
            PlannedView view(pitch);
            WaterSurface& water = view.add(0.0, 0.05);
            set(water, &ViewSettings::guardBand, kind);
            set(water, &ViewSettings::guardBandShare, 0.0);
            ++kinds[view.kind()];
        }
        INFO("pitch " << pitch);
        CHECK(kinds.size() == 1);
        CHECK(kinds[CaptureKind::VIEW_AND_MIRROR] == 5);
    }
}

// Breaks where the choice asks for the band that is given in place of the one asked for.
TEST_CASE("what is given up for time decides about no mirrored image")
{
    PlannedView view(15.0);
    WaterSurface& water = view.add(0.0, 0.05);
    set(water, &ViewSettings::maxExtraPixels, 3.0);
    REQUIRE(view.kind() == CaptureKind::VIEW);
    set(water, &ViewSettings::frameTimeTarget, 10.0);
    for (view.step = 0; view.step < 7; ++view.step)
    {
        CHECK(view.kind() != CaptureKind::VIEW_AND_MIRROR);
        CHECK(view.plan.accuracyStep <= view.step);
    }
    CHECK_FALSE(decision(view.plan, "all the accuracy asked for").done);

    // A water that gives up nothing, beside one whose band serves it.
    PlannedView both(15.0);
    set(both.add(0.0, 0.05), &ViewSettings::maxExtraPixels, 0.25);
    REQUIRE(both.kind() == CaptureKind::VIEW_AND_MIRROR);
    WaterSurface& other = both.add(0.0, 0.05);
    set(other, &ViewSettings::maxExtraPixels, 3.0);
    REQUIRE(both.kind() == CaptureKind::VIEW);
    set(other, &ViewSettings::frameTimeTarget, 10.0);
    for (both.step = 0; both.step < 7; ++both.step)
        CHECK(both.kind() == CaptureKind::VIEW);
}

// Breaks where a frame that shows another view is copied.
TEST_CASE("a nested view draws its image where a copy is asked for, and says so")
{
    PlannedView view;
    setCapture(view.add(), CaptureKind::FRAME);
    view.make();
    CHECK(view.plan.eyeImage == EyeImage::COPIED);
    CHECK(decision(view.plan, "copied from the frame").done);
    view.facts.nested = true;
    view.make();
    CHECK(view.plan.eyeImage == EyeImage::DRAWN);
    CHECK_FALSE(decision(view.plan, "copied from the frame").done);
}

// Breaks where explain() takes an image that only an effect looks at for one that rays are looked
// for in.
TEST_CASE("an effect that looks at the scene has it copied, and is the reason that is told")
{
    const ListedEffect<Glass> glass;
    PlannedView view;
    view.add().setUserValue("glass", true);
    CHECK(view.kind() == CaptureKind::MIRROR);
    CHECK(view.plan.eyeImage == EyeImage::COPIED);
    CHECK(contains(NdcExtent(), view.possible)); // so that nothing is culled for it
    CHECK(view.plan.eyeSize.whole() == view.plan.eyeSize.view);
    CHECK_FALSE(view.plan.eyeCells);
    for (const char* subject : {"image of the eye", "copied from the frame"})
    {
        CHECK(decision(view.plan, subject).done);
        CHECK(std::string(decision(view.plan, subject).reason) == "an effect looks at the scene");
    }
    CHECK(decision(view.plan, "mirrored image").done);
    CHECK(std::string(decision(view.plan, "guard band").reason) == "a mirrored image has none");
}

// Breaks where the scale is the first water's, or the loser is not told.
TEST_CASE("the largest scale wins, and who asked for a smaller is told")
{
    PlannedView view;
    set(view.add(), &ViewSettings::captureScale, 0.25);
    set(view.add(), &ViewSettings::captureScale, 0.5);
    view.make();
    CHECK(view.plan.eyeSize.view == glm::ivec2(160, 120));
    CHECK(view.plan.mirrorSize.view == glm::ivec2(160, 120));
    CHECK_FALSE(decision(view.plan, "captureScale of its own", 0).done);
    CHECK(decision(view.plan, "captureScale of its own", 1).done);
}

// Breaks where a reason is left empty, or a decision is made of one sheet only.
TEST_CASE("every decision has its reason, for every sheet")
{
    for (const CaptureKind kind : {CaptureKind::AUTOMATIC, CaptureKind::VIEW, CaptureKind::FRAME,
                                   CaptureKind::MIRROR, CaptureKind::VIEW_AND_MIRROR})
        for (const double steepness : {0.0, 0.05})
            for (const bool redrawsAlike : {false, true})
            {
                PlannedView view;
                setCapture(view.add(0.0, steepness), kind);
                setCapture(view.add(0.5, steepness), kind);
                view.facts.redrawsAlike = redrawsAlike;
                view.make();
                for (const ViewPlan::Sheet& sheet : view.plan.sheets)
                {
                    CHECK(sheet.decisions.size() == view.plan.sheets[0].decisions.size());
                    for (const WaterStatus::Decision& each : sheet.decisions)
                        CHECK(std::strlen(each.reason) > 10);
                    CHECK(decision(view.plan, "mirrored image").done ==
                          (view.plan.sheets[0].mirror >= 0));
                    CHECK(decision(view.plan, "image of the eye").done ==
                          view.plan.sheets[0].usesEyeImage());
                }
            }
}
