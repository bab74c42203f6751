#ifndef OSGWATERREFLECT_WAVES_TROCHOIDALSUM_H
#define OSGWATERREFLECT_WAVES_TROCHOIDALSUM_H

#include "TrochoidalState.h"

#include <vector>

namespace osgWaterReflect
{

/// What a sum of trochoidal waves does at one particle: all that height and normal are made of.
struct TrochoidalParticle
{
    osg::Vec2d displacement; ///< [m] from the rest place
    double height = 0.0;     ///< [m]
    osg::Vec2d gradient;     ///< of the height, by the rest place
    double xx = 1.0;         ///< Jacobian of the place by the rest place, symmetric and positive
    double yy = 1.0;
    double xy = 0.0;

    /// Solves the Jacobian for a right-hand side.
    osg::Vec2d solve(const osg::Vec2d& b) const;
};

/// A sum of trochoidal waves about one place at one time.
class TrochoidalSum
{
public:
    TrochoidalSum(const TrochoidalState& state, const osg::Vec2d& place);

    /// The particle that rests at an offset [m] from the place.
    TrochoidalParticle particleAt(const osg::Vec2d& rest) const;

    /// The particle found at the place itself; its displacement brings it there to within
    /// TOLERANCE times the sum of amplitudes.
    ///   steps  if given, the number of Newton steps that it took
    TrochoidalParticle findParticle(int* steps = nullptr) const;

    /// Sum of the amplitudes [m]: no particle strays further from its rest place.
    double reach() const { return _reach; }

    /// [1] of the reach; a thousand times the rounding of double precision there.
    static constexpr double TOLERANCE = 1e-12;

private:
    struct Term
    {
        osg::Vec2d k;          // wave vector [rad/m]
        double amplitude;      // [m]
        double amplitudeOverK; // [m^2]
        double phase;          // [rad] at the place and time, reduced
    };

    std::vector<Term> _terms;
    double _rise = 0.0;
    double _reach = 0.0;
};

} // namespace osgWaterReflect

#endif
