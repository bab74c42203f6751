#ifndef OSGWATERREFLECT_TESTS_BENCH_WALLCASE_H
#define OSGWATERREFLECT_TESTS_BENCH_WALLCASE_H

#include "DrawnStillWater.h"

#include <osgwaterbench/measures/Truth.h>

/// Calm water at z = 0 and an upright wall across it, all of which the view shows. What the water
/// reflects is known in closed form: the eye's mirror image looks at the wall.
struct WallCase
{
    WallCase();

    /// Where the eye's mirror image sees the wall's plane through a water pixel.
    glm::dvec3 mirrored(std::size_t pixel) const;
    bool onWall(const glm::dvec3& place) const;

    /// The place of the wall's plane that is seen a number of pixels beside another one.
    glm::dvec3 beside(const glm::dvec3& place, const glm::dvec2& pixels) const;

    /// Right everywhere.
    osgwaterbench::Answers rightAnswers() const;

    ViewAhead view;
    double distance = 20.0; ///< [m] y of the wall
    double halfWidth = 6.0; ///< [m] about x = 0
    double height = 3.0;    ///< [m]
    glm::dvec3 colour{0.5, 0.25, 0.125};
    glm::dvec3 skyColour{0.25, 0.5, 1.0};
    double thickness = 0.5; ///< [m]

    osgwaterbench::DrawnWater drawn;
    osg::ref_ptr<osg::Node> node;
    osgWaterReflect::reference::SceneTracer scene;
    osgwaterbench::SkyLookup sky;
    osgwaterbench::TrueWorld world;
    osgwaterbench::Truth truth;
};

#endif
