#include <osgWaterReflect/TrochoidalWaves>

#include "Check.h"
#include "trace/Bindings.h"

#include <osg/Math>

#include <limits>

using namespace osgWaterReflect;

namespace
{

const double GRAVITY = 9.80665; // [m/s^2] standard gravity [ISO80000 4-12]

double waveNumber(const TrochoidalWave& wave)
{
    return 2.0 * osg::PI / wave.length;
}

osg::Vec2d direction(const TrochoidalWave& wave)
{
    const double angle = osg::DegreesToRadians(wave.directionDegrees);
    return osg::Vec2d(std::cos(angle), std::sin(angle));
}

double steepnessSum(const std::vector<TrochoidalWave>& waves)
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : waves)
        sum += waveNumber(wave) * wave.amplitude;
    return sum;
}

// How much the trochoids' mean height sinks: particles under a crest are closer together than
// under a trough. Half the sum of k a^2.
double meanSink(const std::vector<TrochoidalWave>& waves)
{
    double sum = 0.0;
    for (const TrochoidalWave& wave : waves)
        sum += 0.5 * waveNumber(wave) * wave.amplitude * wave.amplitude;
    return sum;
}

// Phase at a place, reduced in double precision, in (-2 pi, 2 pi).
double phaseAt(const TrochoidalWave& wave, const osg::Vec2d& place, double time)
{
    const double turn = 2.0 * osg::PI;
    const double k = waveNumber(wave);
    const double frequency = std::sqrt(GRAVITY * k); // deep water
    const double travelled = std::fmod(k * (direction(wave) * place), turn);
    return std::fmod(travelled - std::fmod(frequency * time, turn) + wave.phase, turn);
}

// Newton steps of the shader. With so many, its place is wrong by less than a hundredth of the
// sum of amplitudes (docs/waves.md has the table).
int newtonSteps(double steepness)
{
    if (steepness <= 0.25) return 2;
    if (steepness <= 0.5) return 3;
    if (steepness <= 0.8) return 5;
    return 12;
}

} // namespace

// What the surface does at a particle: all that height and normal are made of.
struct TrochoidalWaves::Particle
{
    osg::Vec2d displacement;
    double height = 0.0;
    osg::Vec2d gradient; // of the height, by the rest place
    double xx = 1.0;     // Jacobian of the place by the rest place, symmetric
    double yy = 1.0;
    double xy = 0.0;

    Particle(const std::vector<TrochoidalWave>& waves, const osg::Vec2d& rest, double time) :
        height(meanSink(waves))
    {
        for (const TrochoidalWave& wave : waves)
        {
            const osg::Vec2d d = direction(wave);
            const double k = waveNumber(wave);
            const double theta = phaseAt(wave, rest, time);
            const double s = wave.amplitude * std::sin(theta);
            const double c = wave.amplitude * std::cos(theta);
            displacement -= d * s;
            height += c;
            gradient -= d * (k * s);
            xx -= k * d.x() * d.x() * c;
            yy -= k * d.y() * d.y() * c;
            xy -= k * d.x() * d.y() * c;
        }
    }

    // Solves the Jacobian for a right-hand side.
    osg::Vec2d solve(const osg::Vec2d& b) const
    {
        const double determinant = xx * yy - xy * xy;
        return osg::Vec2d(yy * b.x() - xy * b.y(), xx * b.y() - xy * b.x()) / determinant;
    }
};

// The rest place minimises a strictly convex function (the displacement is a gradient and the
// steepness sum is below 1), so Newton's method with halved steps always arrives.
TrochoidalWaves::Particle TrochoidalWaves::findParticle(const osg::Vec2d& place, double time) const
{
    const double tolerance = 1e-10 * getAmplitude();
    osg::Vec2d rest = place;
    Particle particle(_waves, rest, time);
    osg::Vec2d residual = place - rest - particle.displacement;
    for (int i = 0; i < 100 && residual.length() > tolerance; ++i)
    {
        const osg::Vec2d step = particle.solve(residual);
        for (double damping = 1.0; damping > 1e-3; damping *= 0.5)
        {
            const osg::Vec2d candidate = rest + step * damping;
            const Particle there(_waves, candidate, time);
            const osg::Vec2d residualThere = place - candidate - there.displacement;
            if (residualThere.length() < residual.length())
            {
                rest = candidate;
                particle = there;
                residual = residualThere;
                break;
            }
        }
    }
    return particle;
}

TrochoidalWaves::TrochoidalWaves(const TrochoidalWaves& rhs, const osg::CopyOp& copyop) :
    WaveModel(rhs, copyop), _waves(rhs._waves)
{
}

TrochoidalWaves* TrochoidalWaves::createBreeze(double length, double steepness,
                                               double directionDegrees)
{
    if (!expectPositive("TrochoidalWaves::createBreeze length", length)) return nullptr;
    if (!(steepness > 0.0 && steepness < 1.0))
    {
        refuse("TrochoidalWaves::createBreeze steepness", "a value in (0, 1)", steepness);
        return nullptr;
    }

    // Lengths fall by a ratio without small whole multiples, so that the pattern does not repeat;
    // directions and phases are spread by the golden angle, shorter waves wider.
    const int count = 8;
    const double ratio = 0.7071;
    const double goldenTurn = 0.38196601;
    std::vector<TrochoidalWave> waves(count);
    for (int i = 0; i < count; ++i)
    {
        const double spread = std::fmod(i * goldenTurn, 1.0) - 0.5; // [-0.5, 0.5)
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
        if (!expectPositive("TrochoidalWave::length", wave.length)) return false;
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

double TrochoidalWaves::getHeight(const osg::Vec2d& place, double time) const
{
    return findParticle(place, time).height;
}

osg::Vec3d TrochoidalWaves::getNormal(const osg::Vec2d& place, double time) const
{
    const Particle particle = findParticle(place, time);
    const osg::Vec2d slope = particle.solve(particle.gradient);
    osg::Vec3d normal(-slope.x(), -slope.y(), 1.0);
    normal.normalize();
    return normal;
}

double TrochoidalWaves::getAmplitude() const
{
    double sum = meanSink(_waves);
    for (const TrochoidalWave& wave : _waves)
        sum += wave.amplitude;
    return sum;
}

double TrochoidalWaves::getShortestLength() const
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const TrochoidalWave& wave : _waves)
        if (wave.amplitude > 0.0) shortest = std::min(shortest, wave.length);
    return shortest;
}

void TrochoidalWaves::apply(osg::StateSet& stateSet, const osg::Vec2d& anchor, double time) const
{
    osg::Uniform* array =
        stateSet.getOrCreateUniform(bindings::WAVES, osg::Uniform::FLOAT_VEC4, MAX_WAVES);
    for (unsigned int i = 0; i < _waves.size(); ++i)
    {
        const TrochoidalWave& wave = _waves[i];
        const osg::Vec2d k = direction(wave) * waveNumber(wave);
        array->setElement(i, osg::Vec4(k.x(), k.y(), wave.amplitude, phaseAt(wave, anchor, time)));
    }
    bindings::set(stateSet, bindings::WAVE_COUNT, static_cast<int>(_waves.size()));
    bindings::set(stateSet, bindings::WAVE_ITERATIONS, newtonSteps(getSteepness()));
    bindings::set(stateSet, bindings::WAVE_RISE, static_cast<float>(meanSink(_waves)));
}
