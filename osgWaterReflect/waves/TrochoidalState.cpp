#include "TrochoidalState.h"

#include "../shaders/Bindings.h"
#include "TrochoidalSum.h"

#include <osg/Math>

#include <cmath>
#include <string>

using namespace osgWaterReflect;

namespace
{

const double GRAVITY = 9.80665; // [m/s^2] standard gravity [ISO80000 4-12]
const double TURN = 2.0 * osg::PI;

// Uniforms of waves_trochoidal.glsl.
const std::string WAVE_TERMS = "osgwr_waveTerms";
const std::string WAVE_TERM_COUNT = "osgwr_waveTermCount";
const std::string WAVE_NEWTON_STEPS = "osgwr_waveNewtonSteps";
const std::string WAVE_REACH = "osgwr_waveReach";
const std::string WAVE_RISE = "osgwr_waveRise";

// Newton steps of the shader, by steepness sum: with so many its height errs by less than 1 % of
// the sum of amplitudes and its normal by less than half a degree, but for one place in a thousand
// (docs/waves.md has the table).
int newtonSteps(double steepness)
{
    if (steepness <= 0.25) return 1;
    if (steepness <= 0.6) return 2;
    if (steepness <= 0.9) return 3;
    return steepness <= 0.99 ? 4 : 8;
}

} // namespace

double osgWaterReflect::waveNumber(const TrochoidalWave& wave)
{
    return TURN / wave.length;
}

osg::Vec2d osgWaterReflect::waveDirection(const TrochoidalWave& wave)
{
    const double angle = osg::DegreesToRadians(std::fmod(wave.directionDegrees, 360.0));
    return osg::Vec2d(std::cos(angle), std::sin(angle));
}

double osgWaterReflect::meanSink(const std::vector<TrochoidalWave>& waves)
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : waves)
        sum += 0.5 * waveNumber(wave) * wave.amplitude * wave.amplitude;
    return sum;
}

double osgWaterReflect::steepnessSum(const std::vector<TrochoidalWave>& waves)
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : waves)
        sum += waveNumber(wave) * wave.amplitude;
    return sum;
}

TrochoidalTerm::TrochoidalTerm(const TrochoidalWave& wave, double time) :
    direction(waveDirection(wave)), number(waveNumber(wave)), amplitude(wave.amplitude)
{
    const double frequency = std::sqrt(GRAVITY * number); // [rad/s] in deep water
    phase = std::fmod(wave.phase - std::fmod(frequency * time, TURN), TURN);
}

double TrochoidalTerm::phaseAt(const osg::Vec2d& place) const
{
    return std::fmod(std::fmod(number * (direction * place), TURN) + phase, TURN);
}

TrochoidalState::TrochoidalState(const std::vector<TrochoidalWave>& waves, double time) :
    _rise(meanSink(waves))
{
    _terms.reserve(waves.size());
    for (const TrochoidalWave& wave : waves)
        _terms.emplace_back(wave, time);
}

double TrochoidalState::getHeight(const osg::Vec2d& place) const
{
    return TrochoidalSum(*this, place).findParticle().height;
}

osg::Vec3d TrochoidalState::getNormal(const osg::Vec2d& place) const
{
    const TrochoidalParticle particle = TrochoidalSum(*this, place).findParticle();
    const osg::Vec2d slope = particle.solve(particle.gradient);
    osg::Vec3d normal(-slope.x(), -slope.y(), 1.0);
    normal.normalize();
    return normal;
}

void TrochoidalState::apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const
{
    osg::Uniform* array = stateSet.getOrCreateUniform(WAVE_TERMS, osg::Uniform::FLOAT_VEC4,
                                                      TrochoidalWaves::MAX_WAVES);
    double reach = 0.0;
    double steepness = 0.0;
    for (unsigned int i = 0; i < _terms.size(); ++i)
    {
        const TrochoidalTerm& term = _terms[i];
        const osg::Vec2d k = term.direction * term.number;
        array->setElement(
            i, osg::Vec4(k.x(), k.y(), term.amplitude / term.number, term.phaseAt(anchor)));
        reach += term.amplitude;
        steepness += term.number * term.amplitude;
    }
    bindings::set(stateSet, WAVE_TERM_COUNT, static_cast<int>(_terms.size()));
    bindings::set(stateSet, WAVE_NEWTON_STEPS, newtonSteps(steepness));
    bindings::set(stateSet, WAVE_REACH, static_cast<float>(reach));
    bindings::set(stateSet, WAVE_RISE, static_cast<float>(_rise));
}
