#ifndef OSGWATERREFLECT_WAVES_TROCHOIDALSTATE_H
#define OSGWATERREFLECT_WAVES_TROCHOIDALSTATE_H

#include <osgWaterReflect/TrochoidalWaves>

#include <vector>

namespace osgWaterReflect
{

/// A trochoidal wave at one time, with what does not depend on the place worked out.
struct TrochoidalTerm
{
    TrochoidalTerm(const TrochoidalWave& wave, double time);

    /// Phase [rad] at a place [m], reduced in double precision to less than a turn either way: what
    /// follows from it does not depend on how far away or how late that is.
    double phaseAt(const osg::Vec2d& place) const;

    osg::Vec2d direction;   ///< of unit length
    double number = 0.0;    ///< [rad/m]
    double amplitude = 0.0; ///< [m]
    double phase = 0.0;     ///< [rad] at place (0, 0), reduced
};

/// Trochoidal waves at one time.
class TrochoidalState : public WaveState
{
public:
    TrochoidalState(const std::vector<TrochoidalWave>& waves, double time);

    double getHeight(const osg::Vec2d& place) const override;
    osg::Vec3d getNormal(const osg::Vec2d& place) const override;
    void apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const override;

    const std::vector<TrochoidalTerm>& terms() const { return _terms; }

    /// How far the sum is lifted so that its mean height is 0 [m].
    double rise() const { return _rise; }

private:
    std::vector<TrochoidalTerm> _terms;
    double _rise;
};

/// Wave number [rad/m] and unit direction of a wave.
double waveNumber(const TrochoidalWave& wave);
osg::Vec2d waveDirection(const TrochoidalWave& wave);

/// How much the mean height of the bare sum sinks [m]: particles under a crest are closer together
/// than under a trough. Half the sum of k a^2.
double meanSink(const std::vector<TrochoidalWave>& waves);

/// Sum of wave number times amplitude [1].
double steepnessSum(const std::vector<TrochoidalWave>& waves);

} // namespace osgWaterReflect

#endif
