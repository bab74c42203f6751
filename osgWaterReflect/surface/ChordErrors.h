#ifndef OSGWATERREFLECT_SURFACE_CHORDERRORS_H
#define OSGWATERREFLECT_SURFACE_CHORDERRORS_H

#include <osgWaterReflect/WaveModel>

#include <array>

namespace osgWaterReflect
{

/// WaveModel::getChordError by the length of the edge, to be asked for very many edges: from a
/// table, without a root or a logarithm. Never falls with the length.
class ChordErrors
{
public:
    /// Of waves that are not known: infinite.
    ChordErrors();

    ///   shortest  [m] > 0; of the edges that will be asked for
    ChordErrors(const WaveModel& waves, double shortest);

    /// Square of the error [m^2] by the square of the edge's length [m^2].
    double squaredAt(double squaredLength) const;

    bool operator==(const ChordErrors& rhs) const;

private:
    // [1] Lengths up to 2^23 times the shortest; longer edges are taken for as long as that.
    static constexpr int COUNT = 47;

    double _squaredShortest = 1.0;     // [m^2]
    std::array<double, COUNT> _values; // [m^2] at the shortest length times sqrt(2)^i
};

} // namespace osgWaterReflect

#endif
