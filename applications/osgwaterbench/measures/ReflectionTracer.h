#ifndef OSGWATERBENCH_REFLECTIONTRACER_H
#define OSGWATERBENCH_REFLECTIONTRACER_H

#include "ViewPixels.h"

#include <osgWaterReflect/reference/SceneTracer.h>

namespace osgwaterbench
{

/// Where what a water pixel truly reflects is to be found.
enum class TrueClass
{
    SKY,          ///< nowhere: the ray meets nothing
    VISIBLE,      ///< in the view's image, where nothing hides it
    HIDDEN,       ///< there, but behind something else, or behind itself
    OUTSIDE_TOP,  ///< past the image's upper edge
    OUTSIDE_SIDES ///< past another edge, behind the eye, or before the near plane
};

const int TRUE_CLASS_COUNT = 5;

/// What a reflected ray meets in the scene.
struct ReflectedPlace
{
    TrueClass trueClass = TrueClass::SKY;
    glm::dvec3 dirWorld{0.0};   ///< of the ray
    glm::dvec3 placeWorld{0.0}; ///< unless SKY
    glm::dvec2 window{0.0};     ///< [pixels] of the view, of a place that is ahead
    glm::dvec3 colour{0.0};     ///< of the scene there, as drawn without light; unless SKY
};

/// Follows lines of sight that water reflects into the scene itself, in double precision.
///
/// The scene has no water: waves stop no ray, and what stands below their level is met. Where the
/// place is seen is told by lines of sight in the same scene. Beyond an edge, that edge counts
/// which the ray's image, a straight line from the water's pixel, passes first.
/// May be asked by many threads at once.
class ReflectionTracer
{
public:
    /// Both are kept by reference.
    ReflectionTracer(const DrawnWater& drawn, const osgWaterReflect::reference::SceneTracer& scene);

    /// What the water at a place reflects.
    ///   normalEye  of unit length, facing the eye
    ReflectedPlace trace(const glm::dvec3& pointEye, const glm::dvec3& normalEye) const;

    const ViewPixels& pixels() const { return _pixels; }

private:
    TrueClass classOf(const glm::dvec3& waterWorld, const ReflectedPlace& reflected) const;

    const DrawnWater& _drawn;
    const osgWaterReflect::reference::SceneTracer& _scene;
    ViewPixels _pixels;
    glm::dmat4 _worldFromEye;
};

} // namespace osgwaterbench

#endif
