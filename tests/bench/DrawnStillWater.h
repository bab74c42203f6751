#ifndef OSGWATERREFLECT_TESTS_BENCH_DRAWNSTILLWATER_H
#define OSGWATERREFLECT_TESTS_BENCH_DRAWNSTILLWATER_H

#include <osgwaterbench/measures/ReflectionTracer.h>

#include <functional>

/// An upright view along +y.
struct ViewAhead
{
    glm::dvec3 eye{0.0, 0.0, 2.0};
    double pitchDegrees = 10.0; ///< downward
    double fovyDegrees = 46.0;
    int width = 160; ///< [pixels]
    int height = 120;

    glm::dmat4 eyeFromWorld() const;
    glm::dmat4 clipFromEye() const; ///< near 0.1, far 1000
};

/// What a frame with calm level water would be read back as, worked out without drawing.
///   level    [world units] z of the water
///   isWater  whether a place of that plane is to be seen
osgwaterbench::DrawnWater drawStillWater(const ViewAhead& view,
                                         const std::function<bool(const glm::dvec3&)>& isWater,
                                         double level = 0.0);

/// The drawn place of a water pixel, in the world.
glm::dvec3 waterPoint(const osgwaterbench::DrawnWater& drawn, std::size_t pixel);

/// Place of a window [pixels] at a depth along the view's axis [world units], in the world.
glm::dvec3 placeAtWindow(const osgwaterbench::DrawnWater& drawn, const glm::dvec2& window,
                         double depth);

#endif
