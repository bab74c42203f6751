#ifndef OSGWATERREFLECT_BAND_REFLECTEDEXTENT_H
#define OSGWATERREFLECT_BAND_REFLECTEDEXTENT_H

#include "NdcExtent.h"

#include <vector>

namespace osgWaterReflect
{

/// What of a sheet of water decides how far the rays that it reflects go.
struct ReflectingSheet
{
    const std::vector<glm::dvec2>* hull = nullptr; ///< surface space, convex
    glm::dmat4 eyeFromSurface{1.0};
    double amplitude = 0.0; ///< of the waves [surface units]
    double maxSlope = 0.0;  ///< [1] of the waves
    double side = 1.0;      ///< +1: the eye is above the water; -1: below
};

/// Where the rays that the visible part of a sheet reflects come to in the image, were the scene
/// infinitely large, and the view itself. A pure function, continuous in the camera but where a ray
/// begins to turn away from the view: its side goes to infinity.
///
/// Of 6,000 random views that were swept with some thousand rays each, none left it. Of the sides
/// that rays came to within ten times the view, 99 % lie at most 0.6 % beyond the farthest ray;
/// those that lie 5 to 40 % beyond it look at crests as high as the eye, or along the image's
/// plane.
NdcExtent reflectedExtent(const ReflectingSheet& sheet, const glm::dmat4& clipFromEye);

} // namespace osgWaterReflect

#endif
