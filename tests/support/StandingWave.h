#ifndef OSGWATERREFLECT_TESTS_SUPPORT_STANDINGWAVE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_STANDINGWAVE_H

// The wave model of docs/extending.md, which has it word for word from here on.
#include <osgWaterReflect/WaveModel>

#include <cmath>

/// A wave between two walls, along x: it rises and falls in its place.
class StandingWave : public osgWaterReflect::WaveModel
{
public:
    StandingWave() = default;
    StandingWave(const StandingWave& rhs, const osg::CopyOp& copyop) : WaveModel(rhs, copyop) {}
    META_Object(example, StandingWave)

    osg::ref_ptr<const osgWaterReflect::WaveState> createState(double time) const override
    {
        return new State(time);
    }

    double getAmplitude() const override { return AMPLITUDE; }
    double getMaxSlope() const override { return WAVE_NUMBER * AMPLITUDE; }
    double getShortestLength() const override { return LENGTH; }

    /// The mean square of a sine is a half, over places and over times.
    osg::Vec3d getSlopeCovariance(double length) const override
    {
        const double variance = 0.25 * getMaxSlope() * getMaxSlope();
        return LENGTH < length ? osg::Vec3d(variance, 0.0, 0.0) : osg::Vec3d();
    }

    const osgWaterReflect::ShaderPiece* getShaderPiece() const override
    {
        static const osg::ref_ptr<const osgWaterReflect::ShaderPiece> piece =
            new osgWaterReflect::ShaderPiece("waves_standing.glsl", R"glsl(
uniform vec3 example_wave; // wave number [rad/m], phase at p = 0 [rad], height of a crest [m]

float waveHeight(vec2 p)
{
    return example_wave.z * cos(example_wave.x * p.x + example_wave.y);
}

float highestWave()
{
    return abs(example_wave.z);
}

WaveSlope waveSlope(vec2 p, vec2 dPdx, vec2 dPdy)
{
    // A Gaussian of half a pixel's standard deviation leaves exp(-variance / 2) of a sine.
    vec2 phasePerPixel = example_wave.x * vec2(dPdx.x, dPdy.x);
    float left = exp(-0.125 * dot(phasePerPixel, phasePerPixel));
    float steepness = example_wave.x * example_wave.z;
    float slope = -steepness * left * sin(example_wave.x * p.x + example_wave.y);
    float variance = 0.5 * steepness * steepness * (1.0 - left * left);
    return WaveSlope(vec2(slope, 0.0), vec3(variance, 0.0, 0.0));
}
)glsl");
        return piece;
    }

protected:
    ~StandingWave() override = default;

private:
    static constexpr double AMPLITUDE = 0.1; // [m]
    static constexpr double LENGTH = 3.0;    // [m]
    static constexpr double WAVE_NUMBER = 2.0 * M_PI / LENGTH;

    /// The wave at one time.
    class State : public osgWaterReflect::WaveState
    {
    public:
        /// A crest's height in deep water.
        explicit State(double time) :
            _height(AMPLITUDE * std::cos(std::sqrt(9.80665 * WAVE_NUMBER) * time))
        {
        }

        double getHeight(const osg::Vec2d& place) const override
        {
            return _height * std::cos(WAVE_NUMBER * place.x());
        }

        osg::Vec3d getNormal(const osg::Vec2d& place) const override
        {
            const double slope = -WAVE_NUMBER * _height * std::sin(WAVE_NUMBER * place.x());
            osg::Vec3d normal(-slope, 0.0, 1.0);
            normal.normalize();
            return normal;
        }

        void apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const override
        {
            const double phase = std::fmod(WAVE_NUMBER * anchor.x(), 2.0 * osg::PI);
            stateSet.getOrCreateUniform("example_wave", osg::Uniform::FLOAT_VEC3)
                ->set(osg::Vec3(WAVE_NUMBER, phase, _height));
        }

    private:
        const double _height; // [m] of a crest now
    };
};

#endif
