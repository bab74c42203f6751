#pragma once

#include <osg/Math>

#include <random>

namespace waterdata
{

// The standard fixes std::mt19937's output but not that of its distributions, so the conversions
// are made here: the same seed gives the same scene with every standard library.
class Random
{
public:
    explicit Random(unsigned int seed) : _engine(seed) {}

    float unit() { return static_cast<float>(_engine() >> 8) * (1.0f / 16777216.0f); }
    float between(float low, float high) { return low + (high - low) * unit(); }
    float angle() { return between(0.0f, 2.0f * osg::PIf); }
    int below(int count) { return static_cast<int>(_engine() % static_cast<unsigned int>(count)); }

private:
    std::mt19937 _engine;
};

}
