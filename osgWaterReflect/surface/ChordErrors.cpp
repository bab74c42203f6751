#include "ChordErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgWaterReflect;

namespace
{

// In place of what is infinite: two of these are mixed without becoming NaN.
const double UNKNOWN = std::numeric_limits<double>::max();

} // namespace

ChordErrors::ChordErrors()
{
    _values.fill(UNKNOWN);
}

ChordErrors::ChordErrors(const WaveModel& waves, double shortest) :
    _squaredShortest(shortest * shortest)
{
    double largest = 0.0;
    for (int i = 0; i < COUNT; ++i)
    {
        const double error = waves.getChordError(std::sqrt(std::ldexp(_squaredShortest, i)));
        largest = std::max(largest, std::min(error * error, UNKNOWN));
        _values[i] = largest;
    }
}

// Between two entries the squared error, which grows with the length's fourth power at first, is
// taken to grow with its square: up to 12 % too large, the error itself up to 6 %.
double ChordErrors::squaredAt(double squaredLength) const
{
    int exponent = 0; // of two, over a part in [1/2, 1)
    const double part = std::frexp(squaredLength / _squaredShortest, &exponent);
    if (exponent < 1) return _values.front();
    if (exponent >= COUNT) return _values.back();
    const double& value = _values[exponent - 1];
    return value + (2.0 * part - 1.0) * (_values[exponent] - value);
}

bool ChordErrors::operator==(const ChordErrors& rhs) const
{
    return _squaredShortest == rhs._squaredShortest && _values == rhs._values;
}
