#include "Fresnel.h"

#include <cmath>

double osgwaterbench::reflectance(double cosIncident, double refractiveIndex)
{
    const double sinRefracted = std::sqrt(1.0 - cosIncident * cosIncident) / refractiveIndex;
    const double cosRefracted = std::sqrt(1.0 - sinRefracted * sinRefracted);
    const double perpendicular = (cosIncident - refractiveIndex * cosRefracted) /
                                 (cosIncident + refractiveIndex * cosRefracted);
    const double parallel = (refractiveIndex * cosIncident - cosRefracted) /
                            (refractiveIndex * cosIncident + cosRefracted);
    return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}
