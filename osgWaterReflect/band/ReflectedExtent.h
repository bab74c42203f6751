#ifndef OSGWATERREFLECT_BAND_REFLECTEDEXTENT_H
#define OSGWATERREFLECT_BAND_REFLECTEDEXTENT_H

#include "NdcExtent.h"

#include <vector>

namespace osgWaterReflect
{

/// What of a sheet of water decides how far the rays that it reflects go, besides its slopes.
struct ReflectingSheet
{
    const std::vector<glm::dvec2>* hull = nullptr; ///< surface space, convex
    glm::dmat4 eyeFromSurface{1.0};
    double amplitude = 0.0; ///< of the waves [surface units]
    double side = 1.0;      ///< +1: the eye is above the water; -1: below
};

/// The rays that the visible part of a sheet reflects in a view.
///
/// Of 6,000 random views that were swept with some thousand rays each, none left the extent. Of the
/// sides that rays came to within ten times the view, 99 % lie at most 0.6 % beyond the farthest
/// ray; those that lie 5 to 40 % beyond it look at crests as high as the eye, or along the image's
/// plane.
class ReflectedRays
{
public:
    ReflectedRays(const ReflectingSheet& sheet, const glm::dmat4& clipFromEye);

    /// Where they come to in the image, were the scene infinitely large, and the view itself. A
    /// pure function, continuous in the camera but where a ray begins to turn away from the view:
    /// its side goes to infinity.
    ///   maxSlope  [1] of the waves
    NdcExtent extent(double maxSlope) const;

private:
    struct SightLine
    {
        glm::dvec3 direction; // in eye space, of any length
        double length;
    };

    glm::dmat4 _clipFromEye;
    glm::dmat3 _normalEyeFromSurface; // toward the eye's side
    std::vector<SightLine> _lines;    // to the corners of what is seen of the sheet
    ImageHull _beginnings;            // of the rays
};

} // namespace osgWaterReflect

#endif
