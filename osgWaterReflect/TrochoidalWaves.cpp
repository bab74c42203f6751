#include <osgWaterReflect/TrochoidalWaves>

#include "Check.h"
#include "shaders/ShaderSource.h"
#include "waves/TrochoidalState.h"

#include <osg/Math>

#include <cmath>
#include <limits>

using namespace osgWaterReflect;

namespace
{

// How far a sine of amplitude 1 strays from chords over an angle [rad]: twice the mean square. It
// is the integral of |exp(i s angle) - (1 - s) - s exp(i angle)|^2 over s from 0 to 1, s being the
// part of the chord that has been gone.
double strayFromChords(double angle)
{
    // Below, the closed form would lose its digits; the series leaves out a 10^7th of it here.
    const double smallAngle = 0.1;
    const double squared = angle * angle;
    if (angle < smallAngle) return squared * squared * (1.0 / 120.0 - squared * (11.0 / 30240.0));
    const double cosine = std::cos(angle);
    return 5.0 / 3.0 + cosine / 3.0 - 4.0 * (1.0 - cosine) / squared;
}

} // namespace

TrochoidalWaves::TrochoidalWaves(const TrochoidalWaves& rhs, const osg::CopyOp& copyop) :
    WaveModel(rhs, copyop), _waves(rhs._waves)
{
}

TrochoidalWaves* TrochoidalWaves::createBreeze(double length, double steepness,
                                               double directionDegrees)
{
    if (!expectRange("TrochoidalWaves::createBreeze length", length, 1e-5, 1e9)) return nullptr;
    if (!(steepness > 0.0 && steepness < 1.0))
    {
        refuse("TrochoidalWaves::createBreeze steepness", "a value in (0, 1)", steepness);
        return nullptr;
    }

    // Each wave is as steep as the next. Directions and phases are spread by the golden angle,
    // which never falls into step: the longest wave runs where it was asked to, shorter ones up to
    // 30 and at last 65 degrees beside it. The ratio of lengths is that of the lowest
    // self-correlation in a scan from 0.5 to 0.82: of the slopes, 0.91 for any shift of up to 20 of
    // the longest waves, where 0.7071 has 0.94.
    const int count = 8;
    const double ratio = 0.75;
    const double goldenTurn = 0.38196601;
    std::vector<TrochoidalWave> waves(count);
    for (int i = 0; i < count; ++i)
    {
        const double spread = std::fmod(0.5 + i * goldenTurn, 1.0) - 0.5; // [-0.5, 0.5)
        waves[i].length = length * std::pow(ratio, i);
        waves[i].amplitude = steepness / count / waveNumber(waves[i]);
        waves[i].directionDegrees = directionDegrees + spread * (60.0 + 10.0 * i);
        waves[i].phase = 2.0 * osg::PI * std::fmod(i * i * goldenTurn, 1.0);
    }

    osg::ref_ptr<TrochoidalWaves> model = new TrochoidalWaves;
    return model->setWaves(waves) ? model.release() : nullptr;
}

bool TrochoidalWaves::setWaves(const std::vector<TrochoidalWave>& waves)
{
    if (waves.size() > MAX_WAVES)
        return refuse("TrochoidalWaves::setWaves", "at most 32 waves", waves.size());
    for (const TrochoidalWave& wave : waves)
    {
        if (!expectRange("TrochoidalWave::length", wave.length, 1e-6, 1e9)) return false;
        if (!(std::isfinite(wave.amplitude) && wave.amplitude >= 0.0))
            return refuse("TrochoidalWave::amplitude", "a finite value of at least 0",
                          wave.amplitude);
        if (!std::isfinite(wave.directionDegrees))
            return refuse("TrochoidalWave::directionDegrees", "a finite value",
                          wave.directionDegrees);
        if (!std::isfinite(wave.phase))
            return refuse("TrochoidalWave::phase", "a finite value", wave.phase);
    }
    const double steepness = steepnessSum(waves);
    if (!(steepness < 1.0))
        return refuse("TrochoidalWaves::setWaves", "a steepness sum below 1", steepness);
    _waves = waves;
    return true;
}

double TrochoidalWaves::getSteepness() const
{
    return steepnessSum(_waves);
}

osg::ref_ptr<const WaveState> TrochoidalWaves::createState(double time) const
{
    return new TrochoidalState(_waves, time);
}

double TrochoidalWaves::getAmplitude() const
{
    double sum = meanSink(_waves);
    for (const TrochoidalWave& wave : _waves)
        sum += wave.amplitude;
    return sum;
}

// Let the slope be m u, with u of unit length, J the Jacobian of the place by the rest place and g
// the height's gradient by the rest place. J m u = g, so that m = (u . g) / (u . J u), which is at
// most sum s |sin| / (1 - sum s |cos|), s being each wave's steepness: with their sum S at most
// S sin / (1 - S cos) of one angle, whose largest value this is, where the cosine is S.
double TrochoidalWaves::getMaxSlope() const
{
    const double steepness = getSteepness();
    return steepness / std::sqrt(1.0 - steepness * steepness);
}

// The slope s sin / (1 - s cos) of one wave of steepness s, squared, is met over the part
// (1 - s cos) of the still level: the integral over all angles is 2 pi (1 - sqrt(1 - s^2)).
// Waves of different wave vectors are uncorrelated.
osg::Vec3d TrochoidalWaves::getSlopeCovariance(double length) const
{
    osg::Vec3d sum;
    for (const TrochoidalWave& wave : _waves)
    {
        if (wave.length >= length) continue;
        const double steepness = waveNumber(wave) * wave.amplitude;
        const double variance = 1.0 - std::sqrt(1.0 - steepness * steepness);
        const osg::Vec2d along = waveDirection(wave);
        sum += osg::Vec3d(along.x() * along.x(), along.y() * along.y(), along.x() * along.y()) *
               variance;
    }
    return sum;
}

double TrochoidalWaves::getShortestLength() const
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const TrochoidalWave& wave : _waves)
        if (wave.amplitude > 0.0) shortest = std::min(shortest, wave.length);
    return shortest;
}

// Waves of different wave vectors are uncorrelated.
double TrochoidalWaves::getChordError(double length) const
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : _waves)
        sum += 0.5 * wave.amplitude * wave.amplitude * strayFromChords(waveNumber(wave) * length);
    return std::sqrt(sum);
}

const ShaderPiece* TrochoidalWaves::getShaderPiece() const
{
    static const osg::ref_ptr<const ShaderPiece> piece = libraryPiece("waves_trochoidal.glsl");
    return piece;
}
