#ifndef OSGWATERBENCH_HARNESSWAVES_H
#define OSGWATERBENCH_HARNESSWAVES_H

#include <osgWaterReflect/WaveModel>

#include <vector>

namespace osgwaterbench
{

/// A cosine of the slope: weight * direction * cos(waveNumber * direction . place + phase).
struct HarnessWave
{
    osg::Vec2d direction;    ///< finite; not of unit length everywhere, as it was measured with
    double waveNumber = 1.0; ///< [rad/m] > 0, for a direction of unit length
    double phase = 0.0;      ///< [rad] finite
    double weight = 1.0;     ///< [1] finite
};

/// Flat water with the normals of waves: its height is 0 everywhere, its slope a sum of cosines.
/// A point's normal alone decides where its ray goes, so the true hit is known in closed form.
///
/// Time does not move it, and its GLSL piece averages over no pixel, for neither did what was
/// measured with it before. The piece is shaders/waves_harness.glsl.
class HarnessWaves : public osgWaterReflect::WaveModel
{
public:
    HarnessWaves() = default;
    HarnessWaves(const HarnessWaves& rhs, const osg::CopyOp& copyop);
    META_Object(osgWaterBench, HarnessWaves)

    /// At most this many waves: the length of the piece's array.
    static const unsigned int MAX_WAVES = 8;

    /// False, with a message and the old waves kept, where a value is out of its range or there are
    /// too many.
    ///   slope  [1] finite, >= 0; multiplies every wave
    bool setWaves(const std::vector<HarnessWave>& waves, double slope);

    osg::ref_ptr<const osgWaterReflect::WaveState> createState(double time) const override;
    double getAmplitude() const override { return 0.0; }
    /// The largest sum of the waves' slopes, each as steep as it gets to one side or the other: the
    /// least bound where no wave vector is a sum of multiples of others.
    double getMaxSlope() const override;
    osg::Vec3d getSlopeCovariance(double length) const override;
    /// Infinite, for no mesh need follow flat water.
    double getShortestLength() const override;
    double getChordError(double) const override { return 0.0; }
    const osgWaterReflect::ShaderPiece* getShaderPiece() const override;

protected:
    ~HarnessWaves() override = default;

private:
    class State;

    std::vector<HarnessWave> _waves;
    double _slope = 0.0;
};

} // namespace osgwaterbench

#endif
