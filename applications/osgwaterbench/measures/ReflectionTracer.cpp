#include "ReflectionTracer.h"

#include "SightLine.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

using namespace osgwaterbench;
using osgWaterReflect::fromOsg;
using osgWaterReflect::toOsg;
using osgWaterReflect::reference::SceneHit;

namespace
{

// Of the water's distance from the eye. What is met before is passed: a drawn point, rounded to
// single precision, may lie just behind what stands in the water. About a twentieth of a pixel's
// side (480 rows over 46 degrees), so that things still join their reflections.
const double NEAREST = 1e-4;

// Of a place's distance from the eye. What stands no farther before it does not hide it: half a
// pixel's side, as above, and more than SceneTracer errs by on a surface that is seen edge-on.
const double CLEARANCE = 1e-3;

// How much of the way from start to end lies before an upper bound; infinite where end is not past
// it.
double shareBefore(double start, double end, double bound)
{
    return end > bound ? (bound - start) / (end - start) : std::numeric_limits<double>::infinity();
}

} // namespace

ReflectionTracer::ReflectionTracer(const DrawnWater& drawn,
                                   const osgWaterReflect::reference::SceneTracer& scene) :
    _drawn(drawn),
    _scene(scene), _pixels(drawn), _worldFromEye(glm::inverse(drawn.eyeFromWorld))
{
}

ReflectedPlace ReflectionTracer::trace(const glm::dvec3& pointEye,
                                       const glm::dvec3& normalEye) const
{
    const glm::dvec3 dirEye = reflectedDirEye(_drawn, pointEye, normalEye);
    const glm::dvec3 waterWorld(_worldFromEye * glm::dvec4(pointEye, 1.0));

    ReflectedPlace reflected;
    reflected.dirWorld = glm::dvec3(_worldFromEye * glm::dvec4(dirEye, 0.0));
    const std::optional<SceneHit> hit =
        _scene.trace(toOsg(waterWorld), toOsg(reflected.dirWorld), NEAREST * glm::length(pointEye));
    if (!hit) return reflected;
    reflected.placeWorld = fromOsg(hit->point);
    reflected.colour = glm::dvec3(hit->colour.r(), hit->colour.g(), hit->colour.b());
    if (_pixels.isAhead(reflected.placeWorld))
        reflected.window = _pixels.window(reflected.placeWorld);
    reflected.trueClass = classOf(waterWorld, reflected);
    return reflected;
}

TrueClass ReflectionTracer::classOf(const glm::dvec3& waterWorld,
                                    const ReflectedPlace& reflected) const
{
    if (!_pixels.isAhead(reflected.placeWorld)) return TrueClass::OUTSIDE_SIDES;
    const glm::dvec2 end = reflected.window;
    if (_pixels.inImage(end))
    {
        const glm::dvec3 placeEye(_drawn.eyeFromWorld * glm::dvec4(reflected.placeWorld, 1.0));
        const bool hidden =
            _scene.occluded(toOsg(_pixels.nearPlace(end)), toOsg(reflected.placeWorld),
                            CLEARANCE * glm::length(placeEye));
        return hidden ? TrueClass::HIDDEN : TrueClass::VISIBLE;
    }
    const glm::dvec2 start = _pixels.window(waterWorld);
    const glm::dvec2 border = _drawn.view.size - 0.5;
    const double left = shareBefore(-start.x, -end.x, -0.5);
    const double right = shareBefore(start.x, end.x, border.x);
    const double bottom = shareBefore(-start.y, -end.y, -0.5);
    const double top = shareBefore(start.y, end.y, border.y);
    return top <= std::min({left, right, bottom}) ? TrueClass::OUTSIDE_TOP
                                                  : TrueClass::OUTSIDE_SIDES;
}
