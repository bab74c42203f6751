// The table of how far waves stray from straight edges.

#include "support/Catch.h"
#include "support/FlatState.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/surface/ChordErrors.h>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

// Waves that answer what they have to, and no more.
class UnknownWaves : public WaveModel
{
public:
    UnknownWaves() = default;
    UnknownWaves(const UnknownWaves& rhs, const osg::CopyOp& copyop) : WaveModel(rhs, copyop) {}
    META_Object(test, UnknownWaves)

    osg::ref_ptr<const osgWaterReflect::WaveState> createState(double) const override
    {
        return new FlatState;
    }
    double getAmplitude() const override { return 1.0; }
    double getMaxSlope() const override { return 1.0; }
    double getShortestLength() const override { return 1.0; }
    const ShaderPiece* getShaderPiece() const override { return nullptr; }

protected:
    ~UnknownWaves() override = default;
};

} // namespace

// Falls when the lengths of entries are powers of 2, or the entries are mixed by the wrong part.
TEST_CASE("the table of chord errors is the model's, and never falls with the length")
{
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.3);
    const osg::ref_ptr<TrochoidalWaves> one = new TrochoidalWaves;
    REQUIRE(one->setWaves({TrochoidalWave()}));
    for (const TrochoidalWaves* waves : {breeze.get(), one.get()})
    {
        const double shortest = waves->getShortestLength() / 8.0;
        const ChordErrors errors(*waves, shortest);
        double last = 0.0;
        double highest = 0.0;
        for (double length = shortest; length < 1e9 * shortest; length *= 1.01)
        {
            const double squared = errors.squaredAt(length * length);
            REQUIRE(squared >= last);
            last = squared;
            highest = std::max(highest, waves->getChordError(length));
            INFO("at " << length / shortest << " of the shortest edge");
            // Measured 0.948 and 1.058: from one entry to the next the length grows by 1.41.
            REQUIRE(std::sqrt(squared) > 0.94 * highest);
            REQUIRE(std::sqrt(squared) < 1.07 * highest);
        }
        CHECK(errors.squaredAt(0.0) == errors.squaredAt(shortest * shortest));
    }
}

// Falls when infinite values are mixed as they are: NaN is above no bound.
TEST_CASE("where waves do not know how far they stray, it is further than any bound")
{
    const osg::ref_ptr<UnknownWaves> unknown = new UnknownWaves;
    for (const ChordErrors& errors : {ChordErrors(), ChordErrors(*unknown, 0.1)})
        for (double length : {1e-9, 0.1, 0.1234, 5.0, 1e12})
            CHECK(errors.squaredAt(length * length) > 1e100);
}

TEST_CASE("tables of chord errors are equal where the waves are")
{
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.3);
    const osg::ref_ptr<TrochoidalWaves> lower = TrochoidalWaves::createBreeze(2.0, 0.2);
    CHECK(ChordErrors(*breeze, 0.1) == ChordErrors(*breeze, 0.1));
    CHECK_FALSE(ChordErrors(*breeze, 0.1) == ChordErrors(*lower, 0.1));
    CHECK_FALSE(ChordErrors(*breeze, 0.1) == ChordErrors(*breeze, 0.2));
}
