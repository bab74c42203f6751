#ifndef OSGWATERBENCH_FRESNEL_H
#define OSGWATERBENCH_FRESNEL_H

namespace osgwaterbench
{

/// Share of unpolarised light that smooth water reflects back into the air, [0, 1], by Fresnel's
/// formulas [Born99 1.5.2].
///   cosIncident      between unit normal and unit direction to the eye, [0, 1]
///   refractiveIndex  of the water over the air's, >= 1
double reflectance(double cosIncident, double refractiveIndex);

} // namespace osgwaterbench

#endif
