// What advances with time in a water: once for each frame, and never under a draw's hands.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/dynamics/WaterDynamics.h>

#include <osgUtil/UpdateVisitor>

using namespace osgWaterReflect;

namespace
{

// A breeze that counts the states which are asked for.
class CountedWaves : public TrochoidalWaves
{
public:
    CountedWaves() { setWaves({TrochoidalWave()}); }

    osg::ref_ptr<const WaveState> createState(double time) const override
    {
        times.push_back(time);
        return TrochoidalWaves::createState(time);
    }

    mutable std::vector<double> times; // [s] of the states that were made
};

class NoState : public TrochoidalWaves
{
    osg::ref_ptr<const WaveState> createState(double) const override { return nullptr; }
};

osg::ref_ptr<osg::FrameStamp> frameStamp(unsigned int number, double time)
{
    const osg::ref_ptr<osg::FrameStamp> frame = new osg::FrameStamp;
    frame->setFrameNumber(number);
    frame->setSimulationTime(time);
    return frame;
}

} // namespace

// Breaks where advance() compares no frame number, or no time; and where at() puts its state in
// the place of the frame's.
TEST_CASE("a water has one state for each frame")
{
    const osg::ref_ptr<CountedWaves> waves = new CountedWaves;
    WaterDynamics dynamics;
    CHECK_FALSE(dynamics.advance(frameStamp(1, 0.5)));
    CHECK_FALSE(dynamics.at(0.5));
    dynamics.setWaves(waves);

    const osg::ref_ptr<const WaveState> first = dynamics.advance(frameStamp(1, 0.5));
    REQUIRE(first);
    CHECK(dynamics.advance(frameStamp(1, 0.5)) == first);
    CHECK(dynamics.at(0.5) == first);
    CHECK(waves->times == std::vector<double>{0.5});

    // A paused simulation draws frames, too.
    const osg::ref_ptr<const WaveState> second = dynamics.advance(frameStamp(2, 0.5));
    CHECK(second != first);
    // Two viewers count their frames, and have their times.
    const osg::ref_ptr<const WaveState> third = dynamics.advance(frameStamp(2, 0.7));
    CHECK(third != second);
    CHECK(waves->times == std::vector<double>{0.5, 0.5, 0.7});

    const osg::Vec2d place(3.0, -1.0);
    CHECK(dynamics.at(9.0)->getHeight(place) == waves->getHeight(place, 9.0));
    CHECK(dynamics.advance(frameStamp(2, 0.7)) == third);
    CHECK(third->getHeight(place) == waves->getHeight(place, 0.7));

    // Without a frame stamp it is the time 0.
    CHECK(dynamics.advance(nullptr)->getHeight(place) == waves->getHeight(place, 0.0));

    // What a draw still holds is as it was, though the model has changed.
    const double before = first->getHeight(place);
    REQUIRE(waves->setWaves({}));
    dynamics.setWaves(waves);
    CHECK(dynamics.advance(frameStamp(2, 0.7))->getHeight(place) == 0.0);
    CHECK(first->getHeight(place) == before);

    dynamics.setWaves(nullptr);
    CHECK_FALSE(dynamics.advance(frameStamp(3, 0.9)));
}

// Breaks where stateOf() hands on what it is given.
TEST_CASE("a wave model that gives no state is named, and its water taken for still")
{
    WaterDynamics dynamics;
    dynamics.setWaves(new NoState);
    Refusals refusals;
    for (unsigned int number = 1; number < 4; ++number)
    {
        const osg::ref_ptr<const WaveState> state = dynamics.advance(frameStamp(number, 0.0));
        REQUIRE(state);
        CHECK(state->getHeight(osg::Vec2d(1, 2)) == 0.0);
        CHECK(state->getNormal(osg::Vec2d(1, 2)) == osg::Vec3d(0, 0, 1));
        CHECK(isRefusalOf("WaveModel::createState", refusals.take()) == (number == 1));
    }
}

// Breaks where takeWaves() does not count, or counts waves that follow waves; and where a copy
// counts none.
TEST_CASE("waves advance in the update traversal, and only they ask for it")
{
    const osg::ref_ptr<WaterSurface> water =
        WaterSurface::createRectangle(osg::Vec3(), osg::Vec3(4, 0, 0), osg::Vec3(0, 4, 0));
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(water);
    CHECK(root->getNumChildrenRequiringUpdateTraversal() == 0);
    water->setWaves(TrochoidalWaves::createBreeze(2.0, 0.1));
    const osg::ref_ptr<CountedWaves> waves = new CountedWaves;
    water->setWaves(waves);
    CHECK(root->getNumChildrenRequiringUpdateTraversal() == 1);
    // It has two ways to the root.
    root->addChild(water);

    osgUtil::UpdateVisitor update;
    for (unsigned int number = 1; number < 4; ++number)
    {
        update.setFrameStamp(frameStamp(number, 0.1 * number));
        root->accept(update);
        CHECK(waves->times.size() == number);
        CHECK(waves->times.back() == 0.1 * number);
    }

    const osg::ref_ptr<WaterSurface> copy = new WaterSurface(*water);
    root->removeChildren(0, 2);
    CHECK(root->getNumChildrenRequiringUpdateTraversal() == 0);
    root->addChild(copy);
    CHECK(root->getNumChildrenRequiringUpdateTraversal() == 1);
    copy->setWaves(nullptr);
    copy->setWaves(nullptr);
    CHECK(root->getNumChildrenRequiringUpdateTraversal() == 0);
}
