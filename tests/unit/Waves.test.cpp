// The waves on the CPU, in double precision.

#include "support/Catch.h"
#include "support/Refusals.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/waves/TrochoidalSum.h>

#include <cmath>
#include <limits>
#include <random>

using namespace osgWaterReflect;

namespace
{

const double PI = 3.14159265358979323846;
const double GRAVITY = 9.80665; // [m/s^2]

osg::ref_ptr<TrochoidalWaves> wavesOf(const std::vector<TrochoidalWave>& list)
{
    osg::ref_ptr<TrochoidalWaves> waves = new TrochoidalWaves;
    REQUIRE(waves->setWaves(list));
    return waves;
}

TrochoidalWave wave(double amplitude, double length, double directionDegrees = 0.0,
                    double phase = 0.0)
{
    TrochoidalWave result;
    result.amplitude = amplitude;
    result.length = length;
    result.directionDegrees = directionDegrees;
    result.phase = phase;
    return result;
}

// One wave of a length [m] and steepness.
TrochoidalWave steepWave(double steepness, double length)
{
    return wave(steepness * length / (2.0 * PI), length, 25.0, 0.4);
}

// Wave systems of a steepness sum: a breeze, one wave, one direction, many.
std::vector<std::vector<TrochoidalWave>> systems(double steepness)
{
    osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(4.0, steepness);
    REQUIRE(breeze);
    std::vector<TrochoidalWave> many;
    for (int i = 0; i < 32; ++i)
    {
        many.push_back(steepWave(steepness / 32, 3.0 * std::pow(0.93, i)));
        many.back().directionDegrees = 137.5 * i;
        many.back().phase = 2.4 * i;
    }
    return {breeze->getWaves(),
            {steepWave(steepness, 2.0)},
            {steepWave(steepness / 2, 2.0), steepWave(steepness / 2, 0.3)},
            many};
}

} // namespace

// Falls when findParticle halves no step (maxHalvings = 1).
TEST_CASE("the particle found at a place is there, whatever the place, time and steepness")
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-6.4e6, 6.4e6);
    std::uniform_real_distribution<double> anytime(-1e7, 1e7);
    for (double steepness : {0.01, 0.1, 0.3, 0.6, 0.9, 0.99, 0.999999})
        for (const std::vector<TrochoidalWave>& waves : systems(steepness))
        {
            int mostSteps = 0;
            double worst = 0.0;
            for (int i = 0; i < 300; ++i)
            {
                const osg::Vec2d place(anywhere(random), anywhere(random));
                const TrochoidalSum sum(TrochoidalState(waves, anytime(random)), place);
                int steps = 0;
                const TrochoidalParticle found = sum.findParticle(&steps);
                // Followed back to its rest place and looked at again, it is the same particle.
                const TrochoidalParticle again = sum.particleAt(-found.displacement);
                worst = std::max(worst,
                                 (again.displacement - found.displacement).length() / sum.reach());
                mostSteps = std::max(mostSteps, steps);
            }
            INFO("steepness " << steepness << ", " << waves.size() << " waves, " << mostSteps
                              << " steps");
            // The rest place differs by the solver's tolerance; the displacement by that times the
            // steepness, which is below 1.
            CHECK(worst < 2.0 * TrochoidalSum::TOLERANCE);
            // Measured: 2 to 7.
            CHECK(mostSteps <= 8);
        }

    // About the sharpest crest that is allowed, where the Jacobian all but vanishes.
    const std::vector<TrochoidalWave> sharp = {wave((1.0 - 1e-9) / PI, 2.0)};
    for (double x = 1.0; x > 1e-16; x *= 0.3)
        for (double sign : {-1.0, 1.0})
        {
            const TrochoidalSum sum(TrochoidalState(sharp, 0.0), osg::Vec2d(sign * x, 0.0));
            int steps = 0;
            const TrochoidalParticle found = sum.findParticle(&steps);
            INFO("place " << sign * x << ", " << steps << " steps");
            const osg::Vec2d again = sum.particleAt(-found.displacement).displacement;
            CHECK((again - found.displacement).length() < 2.0 * TrochoidalSum::TOLERANCE);
            CHECK(steps <= 30);
        }
}

// Falls when getHeight takes the particle that rests at the place (particleAt(osg::Vec2d())).
TEST_CASE("the surface of one wave is a trochoid")
{
    // Gerstner's parametric curve: x = r - a sin(k r), z = a cos(k r), lifted by
    // k a^2 / 2. Direction 0, time 0.
    const double length = 2.0;
    const double k = 2.0 * PI / length;
    for (double steepness : {0.1, 0.5, 0.9, 0.99})
    {
        const double a = steepness / k;
        osg::ref_ptr<TrochoidalWaves> waves = wavesOf({wave(a, length)});
        for (double r = -3.0; r < 3.0; r += 0.01)
        {
            const osg::Vec2d place(r - a * std::sin(k * r), 0.7);
            const double height = a * std::cos(k * r) + 0.5 * k * a * a;
            // Double precision, times the crest's slope, up to 1 / sqrt(1 - 0.99^2) = 7, and its
            // growth toward the crest.
            REQUIRE(waves->getHeight(place, 0.0) == Approx(height).margin(1e-9));
        }
    }
}

// Falls when particleAt's xy loses its sign, or getNormal takes `gradient` for the slope.
TEST_CASE("the normal stands on the height's slope")
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-50.0, 50.0);
    for (double steepness : {0.05, 0.4, 0.8})
        for (const std::vector<TrochoidalWave>& list : systems(steepness))
        {
            osg::ref_ptr<TrochoidalWaves> waves = wavesOf(list);
            // Central differences: wrong by h^2 / 6 of the third derivative, at most
            // k^2 / (1 - steepness)^5, and by rounding over h.
            const double h = 1e-5 * waves->getShortestLength();
            for (int i = 0; i < 100; ++i)
            {
                const osg::Vec2d p(anywhere(random), anywhere(random));
                const double time = anywhere(random);
                const osg::Vec2d dx(h, 0.0);
                const osg::Vec2d dy(0.0, h);
                const double slopeX =
                    (waves->getHeight(p + dx, time) - waves->getHeight(p - dx, time)) / (2.0 * h);
                const double slopeY =
                    (waves->getHeight(p + dy, time) - waves->getHeight(p - dy, time)) / (2.0 * h);
                const osg::Vec3d normal = waves->getNormal(p, time);
                REQUIRE(normal.length() == Approx(1.0).epsilon(1e-12));
                REQUIRE(normal.z() > 0.0);
                REQUIRE(-normal.x() / normal.z() == Approx(slopeX).margin(2e-5));
                REQUIRE(-normal.y() / normal.z() == Approx(slopeY).margin(2e-5));
            }
        }
}

// Falls when TrochoidalSum starts with `_rise(0.0)`.
TEST_CASE("moving water neither rises nor sinks as a whole")
{
    // The mean over 200 by 200 lengths of the longest wave. The bare sum sinks by half the sum of
    // k a^2: 4 % of the sum of amplitudes at this steepness.
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.6);
    REQUIRE(waves);
    const int side = 300;
    const double size = 400.0;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(0.0, 1.0);
    double sum = 0.0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            sum += waves->getHeight(
                osg::Vec2d(size * (x + jitter(random)) / side, size * (y + jitter(random)) / side),
                4.0);
    const double mean = sum / (side * side);
    // One jittered sample in each of 90,000 cells: the standard deviation of the mean is at most
    // that of the height, under a third of the amplitudes, over 300.
    CHECK(std::abs(mean) < 0.004 * waves->getAmplitude());

    // One wave, in closed form to quadrature: the mean over a whole wave, by its place.
    osg::ref_ptr<TrochoidalWaves> one = wavesOf({steepWave(0.7, 2.0)});
    const osg::Vec2d along(std::cos(25.0 * PI / 180.0), std::sin(25.0 * PI / 180.0));
    double total = 0.0;
    for (int i = 0; i < 1000; ++i)
        total += one->getHeight(along * (2.0 * i / 1000.0), 1.0);
    // The trapezoidal rule on a smooth periodic function converges geometrically.
    CHECK(std::abs(total / 1000.0) < 1e-9);
}

// Falls when TrochoidalTerm's frequency loses its square root.
TEST_CASE("a wave travels at the speed of deep water waves of its length")
{
    for (double length : {0.2, 2.0, 100.0})
    {
        const double speed = std::sqrt(GRAVITY * length / (2.0 * PI)); // sqrt(g / k)
        osg::ref_ptr<TrochoidalWaves> waves = wavesOf({wave(0.01 * length, length, 90.0)});
        for (double time : {0.0, 1.7, 30.0})
        {
            // The crest that was at the origin; direction 90 degrees is the surface's y.
            const osg::Vec2d crest(0.3, speed * time);
            const double top = waves->getHeight(crest, time);
            const double step = 0.01 * length;
            CHECK(top > waves->getHeight(crest + osg::Vec2d(0.0, step), time));
            CHECK(top > waves->getHeight(crest - osg::Vec2d(0.0, step), time));
            // A crest is a plus half k a^2 high.
            CHECK(top == Approx(0.01 * length * (1.0 + PI * 0.01)).epsilon(1e-9));
        }
    }
}

// Falls when phaseAt adds before it reduces (std::fmod of the whole sum), and by far when it is
// evaluated in single precision.
TEST_CASE("after a whole number of periods a wave is where it was, far away and very late")
{
    const double length = 0.5;
    const double k = 2.0 * PI / length;
    const double frequency = std::sqrt(GRAVITY * k);
    const double period = 2.0 * PI / frequency;
    const double amplitude = 0.5 / k;
    osg::ref_ptr<TrochoidalWaves> waves = wavesOf({wave(amplitude, length)});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> near(-1.0, 1.0);
    const double epsilon = std::numeric_limits<double>::epsilon();
    for (double place : {0.0, 1e3, 6.4e6})
        for (double periods : {1.0, 1e3, std::floor(1e7 / period)})
            for (int i = 0; i < 50; ++i)
            {
                const osg::Vec2d p(place + near(random), near(random));
                const double time = near(random);
                const double later = time + periods * period;
                // Both times and both phases are rounded in their last bits; the height changes by
                // the amplitude and the sharpening 1 / (1 - 0.5) a radian.
                const double phaseError =
                    4.0 * epsilon * (frequency * later + std::abs(k * p.x()) + 2.0 * PI);
                REQUIRE(waves->getHeight(p, later) ==
                        Approx(waves->getHeight(p, time)).margin(2.0 * amplitude * phaseError));
            }
}

// Falls when TrochoidalTerm reduces `frequency * time` by half a turn.
TEST_CASE("the surface moves without jumps")
{
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(3.0, 0.5);
    REQUIRE(waves);
    // Height changes at a fixed place by at most the sum of frequency times amplitude, sharpened
    // by 1 / (1 - steepness).
    double fastest = 0.0;
    for (const TrochoidalWave& w : waves->getWaves())
        fastest += std::sqrt(GRAVITY * waveNumber(w)) * w.amplitude;
    fastest /= 1.0 - waves->getSteepness();
    for (double start : {0.0, 1e7})
        for (int i = 0; i < 2000; ++i)
        {
            const double step = 0.005;
            const osg::Vec2d place(1.0, 2.0);
            const double change = waves->getHeight(place, start + (i + 1) * step) -
                                  waves->getHeight(place, start + i * step);
            REQUIRE(std::abs(change) < fastest * step);
        }
}

namespace
{

// Root of the mean square of how far a surface strays from its chords of a length, from random
// places in random directions within a half angle [rad] about x.
double sampledChordError(const TrochoidalWaves& waves, double length, double halfAngle)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> anywhere(-1000.0, 1000.0);
    std::uniform_real_distribution<double> anyAngle(-halfAngle, halfAngle);
    std::uniform_real_distribution<double> anyPart(0.0, 1.0);
    const int count = 20000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
        const double angle = anyAngle(random);
        const osg::Vec2d start(anywhere(random), anywhere(random));
        const osg::Vec2d edge(length * std::cos(angle), length * std::sin(angle));
        const double part = anyPart(random);
        const double chord =
            (1.0 - part) * waves.getHeight(start, 0.0) + part * waves.getHeight(start + edge, 0.0);
        const double off = waves.getHeight(start + edge * part, 0.0) - chord;
        sum += off * off;
    }
    return std::sqrt(sum / count);
}

} // namespace

// Falls when strayFromChords has another constant.
TEST_CASE("waves stray from straight edges as far as they say")
{
    const double lengths[] = {0.02, 0.1, 0.3, 0.7, 1.5, 4.0, 11.0, 100.0};
    std::vector<TrochoidalWave> list;
    for (int i = 0; i < 5; ++i)
        list.push_back(wave(0.001 * std::pow(0.8, i), 2.0 * std::pow(0.77, i), 0.0, i));
    const osg::ref_ptr<TrochoidalWaves> along = wavesOf(list);
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.3, 0.0);
    for (double length : lengths)
    {
        INFO(length << " m");
        // 20,000 samples tell a root of a mean square to half a percent; the steepness of 0.015
        // adds another.
        CHECK(sampledChordError(*along, length, 0.0) ==
              Approx(along->getChordError(length)).epsilon(0.03));
        // Waves that run across an edge leave it straight.
        const double share = sampledChordError(*breeze, length, PI) / breeze->getChordError(length);
        CHECK(share > 0.5);
        CHECK(share < 1.1);
    }
    // Short chords: the curvature alone, by the square of the length.
    CHECK(along->getChordError(2e-6) == Approx(4.0 * along->getChordError(1e-6)).epsilon(1e-6));
    CHECK(along->getChordError(1e-6) > 0.0);
    CHECK(wavesOf({})->getChordError(1.0) == 0.0);
}

// Falls when getAmplitude leaves out the rise, or getShortestLength counts waves without height.
TEST_CASE("the stated amplitude bounds the height, and the shortest wave is the shortest seen")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-50.0, 50.0);
    for (const std::vector<TrochoidalWave>& list : systems(0.95))
    {
        osg::ref_ptr<TrochoidalWaves> waves = wavesOf(list);
        for (int i = 0; i < 500; ++i)
            REQUIRE(std::abs(waves->getHeight(osg::Vec2d(anywhere(random), anywhere(random)),
                                              anywhere(random))) <= waves->getAmplitude());
    }
    // A lone crest comes up to it.
    osg::ref_ptr<TrochoidalWaves> one = wavesOf({wave(0.1, 2.0)});
    CHECK(one->getHeight(osg::Vec2d(), 0.0) == Approx(one->getAmplitude()));

    CHECK(wavesOf({wave(0.1, 5.0), wave(0.0, 0.1), wave(0.01, 2.0)})->getShortestLength() == 2.0);
    CHECK(std::isinf(wavesOf({})->getShortestLength()));
}

// Falls when getMaxSlope returns the steepness.
TEST_CASE("no slope is above the stated bound, and one wave comes up to it")
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> anywhere(-50.0, 50.0);
    const auto steepest = [&](const TrochoidalWaves& waves, int places)
    {
        double slope = 0.0;
        for (int i = 0; i < places; ++i)
        {
            const osg::Vec3d normal =
                waves.getNormal(osg::Vec2d(anywhere(random), anywhere(random)), anywhere(random));
            slope = std::max(slope, std::hypot(normal.x(), normal.y()) / normal.z());
        }
        return slope;
    };
    for (double steepness : {0.05, 0.4, 0.8, 0.99})
        for (const std::vector<TrochoidalWave>& list : systems(steepness))
        {
            osg::ref_ptr<TrochoidalWaves> waves = wavesOf(list);
            const double slope = steepest(*waves, 2000);
            // To rounding: one wave has such places, if rarely.
            CHECK(slope <= waves->getMaxSlope() * (1.0 + 1e-9));
            // Of one wave among 2,000 places one is within a hundredth of the steepest.
            if (list.size() == 1) CHECK(slope > 0.99 * waves->getMaxSlope());
        }
    CHECK(wavesOf({})->getMaxSlope() == 0.0);
    // The 3-4-5 triangle.
    CHECK(wavesOf({steepWave(0.6, 2.0)})->getMaxSlope() == Approx(0.75));
}

// Falls when getSlopeCovariance takes waves of the length itself, or swaps xx and yy.
TEST_CASE("the covariance of slopes below a length is that of the waves below it")
{
    const std::vector<TrochoidalWave> longer = {wave(0.08, 5.0, 80.0)};
    const std::vector<TrochoidalWave> shorter = {wave(0.01, 1.0, 25.0), wave(0.006, 0.4, -40.0)};
    std::vector<TrochoidalWave> all = longer;
    all.insert(all.end(), shorter.begin(), shorter.end());
    const osg::ref_ptr<TrochoidalWaves> waves = wavesOf(all);
    const auto expectSlopesOf = [&](const std::vector<TrochoidalWave>& list, double length)
    {
        const osg::ref_ptr<TrochoidalWaves> part = wavesOf(list);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> anywhere(-500.0, 500.0);
        const int places = 40000;
        osg::Vec3d measured;
        for (int i = 0; i < places; ++i)
        {
            const osg::Vec3d normal =
                part->getNormal(osg::Vec2d(anywhere(random), anywhere(random)), anywhere(random));
            const double x = -normal.x() / normal.z();
            const double y = -normal.y() / normal.z();
            measured += osg::Vec3d(x * x, y * y, x * y) / places;
        }
        const osg::Vec3d told = waves->getSlopeCovariance(length);
        INFO("below " << length << " m");
        // The mean of 40,000 errs by 0.4 %, and waves of several directions by their steepness.
        const double tolerance = 0.02 * (measured.x() + measured.y());
        CHECK(std::abs(told.x() - measured.x()) <= tolerance);
        CHECK(std::abs(told.y() - measured.y()) <= tolerance);
        CHECK(std::abs(told.z() - measured.z()) <= tolerance);
    };
    expectSlopesOf(all, std::numeric_limits<double>::infinity());
    expectSlopesOf(shorter, 5.0);
    expectSlopesOf({shorter[1]}, 1.0);
    expectSlopesOf({}, 0.4);
}

// Falls when getSlopeCovariance sums 0.5 s^2 of steepnesses s, or getRmsSlope adds roots.
TEST_CASE("the root of the slopes' mean square is what is stated")
{
    const auto measured = [](const TrochoidalWaves& waves)
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> anywhere(-500.0, 500.0);
        const int places = 20000;
        double sum = 0.0;
        for (int i = 0; i < places; ++i)
        {
            const osg::Vec3d normal =
                waves.getNormal(osg::Vec2d(anywhere(random), anywhere(random)), anywhere(random));
            sum += (normal.x() * normal.x() + normal.y() * normal.y()) / (normal.z() * normal.z());
        }
        return std::sqrt(sum / places);
    };
    // The mean of 20,000 errs by about 1 %.
    for (double steepness : {0.05, 0.4, 0.8, 0.95})
    {
        INFO("steepness " << steepness);
        const osg::ref_ptr<TrochoidalWaves> one = wavesOf({steepWave(steepness, 2.0)});
        CHECK(one->getRmsSlope() == Approx(measured(*one)).epsilon(0.03));
    }
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.2);
    CHECK(breeze->getRmsSlope() == Approx(measured(*breeze)).epsilon(0.03));
    CHECK(breeze->getRmsSlope() == Approx(0.05).epsilon(0.01)); // of eight waves of 0.025
    CHECK(wavesOf({})->getRmsSlope() == 0.0);
}

// Falls when createBreeze spreads `fmod(i * goldenTurn, 1.0) - 0.5`: the longest wave then runs 30
// degrees beside; and with ratio = 0.7071.
TEST_CASE("a breeze has the steepness it was asked for, blows where it was told, does not repeat")
{
    for (double steepness : {0.001, 0.1, 0.5, 0.99})
        for (double direction : {0.0, 30.0, -120.0})
        {
            osg::ref_ptr<TrochoidalWaves> breeze =
                TrochoidalWaves::createBreeze(4.0, steepness, direction);
            REQUIRE(breeze);
            CHECK(breeze->getSteepness() == Approx(steepness).epsilon(1e-12));
            const std::vector<TrochoidalWave>& waves = breeze->getWaves();
            double longest = 0.0;
            osg::Vec2d energy;
            for (const TrochoidalWave& w : waves)
            {
                longest = std::max(longest, w.length);
                energy += waveDirection(w) * (w.amplitude * w.amplitude);
                // Nothing runs against the wind.
                CHECK(std::abs(w.directionDegrees - direction) < 90.0);
            }
            CHECK(longest == 4.0);
            // Energy travels with the wind: within 5 degrees.
            const osg::Vec2d wind(std::cos(direction * PI / 180.0),
                                  std::sin(direction * PI / 180.0));
            CHECK(energy * wind > std::cos(5.0 * PI / 180.0) * energy.length());
        }

    // Correlation of the slopes, which are what one sees, with themselves further on. A pattern
    // that repeats comes back to 1. Eight waves come close somewhere; 0.92 is a little over what
    // they were chosen for.
    osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(1.0, 0.3, 0.0);
    REQUIRE(breeze);
    double most = 0.0;
    for (double x = 0.0; x <= 20.0; x += 0.05)
        for (double y = -20.0; y <= 20.0; y += 0.05)
        {
            if (x * x + y * y < 1.0) continue; // the wave that one looks at
            // Of a sum of sines the correlation is the mean of cos(k . shift), weighed by their
            // squared slopes; here all are as steep.
            double sum = 0.0;
            for (const TrochoidalWave& w : breeze->getWaves())
                sum += std::cos(waveDirection(w) * waveNumber(w) * osg::Vec2d(x, y));
            most = std::max(most, sum / breeze->getWaves().size());
        }
    INFO("correlation " << most);
    CHECK(most < 0.92);
}

// Falls when setWaves assigns before it checks, or tests `steepness > 1.0` for the refusal.
TEST_CASE("waves out of range are refused, by name, and the old waves stay")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    osg::ref_ptr<TrochoidalWaves> waves = wavesOf({wave(0.1, 3.0)});
    Refusals refusals;
    const auto refused = [&](const std::string& member, const std::vector<TrochoidalWave>& list)
    {
        CHECK_FALSE(waves->setWaves(list));
        const std::string message = refusals.take();
        INFO(message);
        CHECK(isRefusalOf(member, message));
        CHECK(waves->getWaves().size() == 1);
        CHECK(waves->getWaves().front().length == 3.0);
    };
    for (double length : {0.0, -0.0, -1.0, nan, inf, -inf, 0.9e-6, 1.1e9})
        refused("TrochoidalWave::length", {wave(0.01, length)});
    for (double amplitude : {-0.01, nan, inf, -inf})
        refused("TrochoidalWave::amplitude", {wave(amplitude, 2.0)});
    for (double direction : {nan, inf, -inf})
    {
        refused("TrochoidalWave::directionDegrees", {wave(0.01, 2.0, direction)});
        refused("TrochoidalWave::phase", {wave(0.01, 2.0, 0.0, direction)});
    }
    refused("TrochoidalWaves::setWaves", {wave(1.0, 2.0 * PI)}); // steepness 1 exactly
    refused("TrochoidalWaves::setWaves", {steepWave(0.5, 2.0), steepWave(0.51, 1.0)});
    refused("TrochoidalWaves::setWaves",
            std::vector<TrochoidalWave>(TrochoidalWaves::MAX_WAVES + 1, wave(0.0, 1.0)));

    for (double length : {0.0, -1.0, nan, inf})
    {
        CHECK_FALSE(TrochoidalWaves::createBreeze(length, 0.1));
        CHECK(isRefusalOf("TrochoidalWaves::createBreeze length", refusals.take()));
    }
    for (double steepness : {0.0, -0.1, 1.0, nan, inf})
    {
        CHECK_FALSE(TrochoidalWaves::createBreeze(2.0, steepness));
        CHECK(isRefusalOf("TrochoidalWaves::createBreeze steepness", refusals.take()));
    }
    CHECK_FALSE(TrochoidalWaves::createBreeze(2.0, 0.1, nan));
    CHECK(isRefusalOf("TrochoidalWave::directionDegrees", refusals.take()));

    // The limits themselves are accepted, without a word.
    CHECK(waves->setWaves({}));
    CHECK(waves->getHeight(osg::Vec2d(1, 2), 3.0) == 0.0);
    CHECK(waves->setWaves({wave(0.0, 1.0)}));
    CHECK(
        waves->setWaves(std::vector<TrochoidalWave>(TrochoidalWaves::MAX_WAVES, wave(0.001, 1.0))));
    CHECK(waves->setWaves({steepWave(1.0 - 1e-9, 2.0)}));
    CHECK(refusals.take().empty());
}

// Falls when the copy constructor leaves out _waves.
TEST_CASE("a copy of waves has the same waves")
{
    osg::ref_ptr<TrochoidalWaves> waves = TrochoidalWaves::createBreeze(2.0, 0.4);
    REQUIRE(waves);
    osg::ref_ptr<osg::Object> copy = waves->clone(osg::CopyOp::DEEP_COPY_ALL);
    const auto* copied = dynamic_cast<TrochoidalWaves*>(copy.get());
    REQUIRE(copied);
    CHECK(copied->getHeight(osg::Vec2d(3, 4), 5.0) == waves->getHeight(osg::Vec2d(3, 4), 5.0));
}
