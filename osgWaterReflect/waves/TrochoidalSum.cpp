#include "TrochoidalSum.h"

#include <cmath>

using namespace osgWaterReflect;

osg::Vec2d TrochoidalParticle::solve(const osg::Vec2d& b) const
{
    const double determinant = xx * yy - xy * xy;
    return osg::Vec2d(yy * b.x() - xy * b.y(), xx * b.y() - xy * b.x()) / determinant;
}

TrochoidalSum::TrochoidalSum(const TrochoidalState& state, const osg::Vec2d& place) :
    _rise(state.rise())
{
    _terms.reserve(state.terms().size());
    for (const TrochoidalTerm& term : state.terms())
    {
        _terms.push_back({term.direction * term.number, term.amplitude,
                          term.amplitude / term.number, term.phaseAt(place)});
        _reach += term.amplitude;
    }
}

TrochoidalParticle TrochoidalSum::particleAt(const osg::Vec2d& rest) const
{
    TrochoidalParticle particle;
    particle.height = _rise;
    for (const Term& term : _terms)
    {
        const double theta = term.k * rest + term.phase;
        const double sine = std::sin(theta);
        const double cosine = std::cos(theta);
        particle.displacement -= term.k * (term.amplitudeOverK * sine);
        particle.height += term.amplitude * cosine;
        particle.gradient -= term.k * (term.amplitude * sine);
        const double share = term.amplitudeOverK * cosine;
        particle.xx -= share * term.k.x() * term.k.x();
        particle.yy -= share * term.k.y() * term.k.y();
        particle.xy -= share * term.k.x() * term.k.y();
    }
    return particle;
}

// The rest place minimises a strictly convex function: the displacement is a gradient and the
// steepness sum is below 1. So the residual falls along Newton's step, far enough down it, and
// halved steps always arrive.
TrochoidalParticle TrochoidalSum::findParticle(int* steps) const
{
    const int maxSteps = 60; // twice what the sharpest crest takes; 7 up to a steepness of 0.999999
    const int maxHalvings = 40;
    const double tolerance = TOLERANCE * _reach;

    osg::Vec2d rest;
    TrochoidalParticle particle = particleAt(rest);
    osg::Vec2d residual = -particle.displacement;
    int step = 0;
    for (; step < maxSteps && residual.length() > tolerance; ++step)
    {
        osg::Vec2d target = rest + particle.solve(residual);
        bool better = false;
        for (int halving = 0; halving < maxHalvings && !better; ++halving)
        {
            const TrochoidalParticle there = particleAt(target);
            const osg::Vec2d residualThere = -target - there.displacement;
            better = residualThere.length() < residual.length();
            if (better)
            {
                rest = target;
                particle = there;
                residual = residualThere;
            }
            target = (rest + target) * 0.5;
        }
        if (!better) break; // as near as double precision can tell
    }
    if (steps) *steps = step;
    return particle;
}
