#ifndef OSGWATERBENCH_VIEWPIXELS_H
#define OSGWATERBENCH_VIEWPIXELS_H

#include "Drawn.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace osgwaterbench
{

/// [pixels] of the view; two places seen no farther apart are the same. The water shows the colour
/// of a whole pixel, 0.7 from its centre at most; the rest is the search's.
const double MATCH_PIXELS = 1.5;

/// Places of the world in the pixels of the view, in which every error is given.
class ViewPixels
{
public:
    explicit ViewPixels(const DrawnWater& drawn);

    /// Whether a place lies beyond the near plane. Only such places are in a window.
    bool isAhead(const glm::dvec3& placeWorld) const;

    /// [pixels] from the lower left corner, of a place ahead.
    glm::dvec2 window(const glm::dvec3& placeWorld) const;

    /// Whether a place of the window lies between the centres of the image's border pixels.
    bool inImage(const glm::dvec2& window) const;

    /// Where the line of sight through a place of the window passes the near plane, in the world.
    glm::dvec3 nearPlace(const glm::dvec2& window) const;

    /// How far apart two places are seen [pixels]; infinite where one of them is not finite.
    ///
    /// Their distance in the window, as long as both are before the eye and no further beside the
    /// image than half its size, which is twice a guard band of 25 %. Further out an image plane
    /// would stretch without bound, and behind the eye there is none: there it is the angle between
    /// them as seen by the eye, in pixels as large as in the direction of the view's axis.
    double distance(const glm::dvec3& aWorld, const glm::dvec3& bWorld) const;

    /// The side of a pixel at a place's distance from the eye [world units].
    double pixelSide(const glm::dvec3& placeWorld) const;

private:
    glm::dvec4 clip(const glm::dvec3& placeWorld) const;
    bool inWideImage(const glm::dvec4& clip) const;

    osgWaterReflect::reference::ImageGeometry _view;
    glm::dmat4 _eyeFromWorld;
    glm::dmat4 _worldFromEye;
    bool _orthographic;
    double _sideAtOne; // [world units] of a pixel, at a distance of 1 unless orthographic
};

} // namespace osgwaterbench

#endif
