#ifndef OSGWATERREFLECT_TESTS_SUPPORT_CHANCE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_CHANCE_H

#include <osg/Math>
#include <osg/Vec3d>

#include <cmath>
#include <initializer_list>
#include <random>

/// Draws by a generator of its own, so that each draw can be had again by the same seed.
class Chance
{
public:
    explicit Chance(unsigned int seed) : _random(seed) {}

    bool once(int in) { return integer(1, in) == 1; }
    int integer(int low, int high)
    {
        return std::uniform_int_distribution<int>(low, high)(_random);
    }
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(_random);
    }
    double logBetween(double low, double high)
    {
        return std::exp(between(std::log(low), std::log(high)));
    }
    template <typename Value>
    Value oneOf(std::initializer_list<Value> values)
    {
        return values.begin()[integer(0, static_cast<int>(values.size()) - 1)];
    }
    osg::Vec3d direction()
    {
        const double z = between(-1.0, 1.0);
        const double turn = between(-osg::PI, osg::PI);
        const double across = std::sqrt(1.0 - z * z);
        return osg::Vec3d(across * std::cos(turn), across * std::sin(turn), z);
    }

private:
    std::mt19937 _random;
};

#endif
