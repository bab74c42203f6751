#include "HarnessWaves.h"

#include "../methods/Methods.h"

#include <osgWaterReflect/Check.h>
#include <osgWaterReflect/shaders/Bindings.h>

#include <osg/Math>
#include <osg/io_utils>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgwaterbench;
using osgWaterReflect::refuse;

namespace
{

const char* const SHADER = "waves_harness.glsl";

// The names of that piece.
const char* const WAVES = "bench_waves";
const char* const WAVE_COUNT = "bench_waveCount";

// [rad/m]
osg::Vec2d waveVector(const HarnessWave& wave)
{
    return wave.direction * wave.waveNumber;
}

// [rad] at a place, reduced in double precision.
double phaseAt(const HarnessWave& wave, const osg::Vec2d& place)
{
    return std::fmod(waveVector(wave) * place + wave.phase, 2.0 * osg::PI);
}

bool check(const HarnessWave& wave)
{
    const char* const member = "HarnessWaves::setWaves";
    if (!(std::isfinite(wave.direction.x()) && std::isfinite(wave.direction.y())))
        return refuse(member, "a finite direction", wave.direction);
    if (!std::isfinite(wave.phase)) return refuse(member, "a finite phase", wave.phase);
    if (!std::isfinite(wave.weight)) return refuse(member, "a finite weight", wave.weight);
    return (std::isfinite(wave.waveNumber) && wave.waveNumber > 0.0) ||
           refuse("HarnessWaves::setWaves waveNumber", "a finite value above 0", wave.waveNumber);
}

} // namespace

// They do not move: one state is that of all times.
class HarnessWaves::State : public osgWaterReflect::WaveState
{
public:
    State(const std::vector<HarnessWave>& waves, double slope) : _waves(waves), _slope(slope) {}

    double getHeight(const osg::Vec2d&) const override { return 0.0; }

    osg::Vec3d getNormal(const osg::Vec2d& place) const override
    {
        osg::Vec2d slope;
        for (const HarnessWave& wave : _waves)
            slope += wave.direction * (_slope * wave.weight * std::cos(phaseAt(wave, place)));
        osg::Vec3d normal(-slope.x(), -slope.y(), 1.0);
        normal.normalize();
        return normal;
    }

    void apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const override
    {
        osg::Uniform* array =
            stateSet.getOrCreateUniform(WAVES, osg::Uniform::FLOAT_VEC4, MAX_WAVES);
        for (unsigned int i = 0; i < _waves.size(); ++i)
        {
            const HarnessWave& wave = _waves[i];
            const osg::Vec2d k = waveVector(wave);
            array->setElement(i, osg::Vec4(k.x(), k.y(), _slope * wave.weight / wave.waveNumber,
                                           phaseAt(wave, anchor)));
        }
        osgWaterReflect::bindings::set(stateSet, WAVE_COUNT, static_cast<int>(_waves.size()));
    }

private:
    const std::vector<HarnessWave> _waves;
    const double _slope;
};

HarnessWaves::HarnessWaves(const HarnessWaves& rhs, const osg::CopyOp& copyop) :
    osgWaterReflect::WaveModel(rhs, copyop), _waves(rhs._waves), _slope(rhs._slope)
{
}

bool HarnessWaves::setWaves(const std::vector<HarnessWave>& waves, double slope)
{
    if (waves.size() > MAX_WAVES)
        return refuse("HarnessWaves::setWaves", "at most 8 waves", waves.size());
    for (const HarnessWave& wave : waves)
        if (!check(wave)) return false;
    if (!(std::isfinite(slope) && slope >= 0.0))
        return refuse("HarnessWaves::setWaves slope", "a finite value of at least 0", slope);
    _waves = waves;
    _slope = slope;
    return true;
}

// Cosines of different wave vectors are uncorrelated, and the mean square of each is a half.
osg::Vec3d HarnessWaves::getSlopeCovariance(double length) const
{
    osg::Vec3d sum;
    for (const HarnessWave& wave : _waves)
    {
        if (2.0 * osg::PI >= length * waveVector(wave).length()) continue;
        const osg::Vec2d& along = wave.direction;
        sum += osg::Vec3d(along.x() * along.x(), along.y() * along.y(), along.x() * along.y()) *
               (0.5 * wave.weight * wave.weight);
    }
    return sum * (_slope * _slope);
}

// A length is convex in each cosine, so that it is largest where all are 1 or -1.
double HarnessWaves::getMaxSlope() const
{
    double steepest = 0.0;
    for (unsigned int signs = 0; signs < 1u << _waves.size(); ++signs)
    {
        osg::Vec2d sum;
        for (unsigned int i = 0; i < _waves.size(); ++i)
            sum += _waves[i].direction * ((signs >> i & 1 ? -1.0 : 1.0) * _waves[i].weight);
        steepest = std::max(steepest, sum.length());
    }
    return _slope * steepest;
}

double HarnessWaves::getShortestLength() const
{
    return std::numeric_limits<double>::infinity();
}

osg::ref_ptr<const osgWaterReflect::WaveState> HarnessWaves::createState(double) const
{
    return new State(_waves, _slope);
}

const osgWaterReflect::ShaderPiece* HarnessWaves::getShaderPiece() const
{
    static const osg::ref_ptr<const osgWaterReflect::ShaderPiece> piece =
        new osgWaterReflect::ShaderPiece(SHADER, benchShaders.at(SHADER));
    return piece;
}
