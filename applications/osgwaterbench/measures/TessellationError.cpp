#include "TessellationError.h"

#include "Parallel.h"
#include "ReflectionTracer.h"
#include "SightLine.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgwaterbench;

namespace
{

// [m] As near to the waves as that is on them: less than drawn points are rounded by.
const double ON_WAVES = 1e-9;

// Of the shortest wave: of a line of sight, looked at step by step. No crest is stepped over.
const double STEP = 0.125;

// At most. Lines of sight so flat that they run over more than a thousand waves are given up;
// regula falsi takes about ten.
const int MOST_STEPS = 10000;

// The waves in eye space.
class WavesEye
{
public:
    WavesEye(const DrawnWater& drawn, const ExactWaves& waves) :
        _waves(waves), _state(waves.model.createState(waves.time)),
        _surfaceFromEye(glm::inverse(waves.eyeFromSurface)),
        _normalEyeFromSurface(osgWaterReflect::normalMatrix(waves.eyeFromSurface)),
        _side(glm::dot(_normalEyeFromSurface[2], drawn.stillNormalEye) < 0.0 ? -1.0 : 1.0)
    {
    }

    glm::dvec3 surfaceFromEye(const glm::dvec4& eye) const
    {
        return glm::dvec3(_surfaceFromEye * eye);
    }

    // How far [m] a place lies off the waves, above 0 on the eye's side.
    double off(const glm::dvec3& pointEye) const
    {
        const glm::dvec3 p = surfaceFromEye(glm::dvec4(pointEye, 1.0));
        return _side * (p.z - _state->getHeight(osg::Vec2d(p.x, p.y)));
    }

    // Unit normal on the eye's side.
    glm::dvec3 normal(const glm::dvec3& pointEye) const
    {
        const glm::dvec3 p = surfaceFromEye(glm::dvec4(pointEye, 1.0));
        const osg::Vec3d normal = _state->getNormal(osg::Vec2d(p.x, p.y));
        return _side * glm::normalize(_normalEyeFromSurface * osgWaterReflect::fromOsg(normal));
    }

    // How fast [m per world unit] a direction leads off the still water, on the eye's side.
    double rise(const glm::dvec3& dirEye) const
    {
        return _side * surfaceFromEye(glm::dvec4(dirEye, 0.0)).z;
    }

    // [world units] along a direction, no longer than STEP of the shortest wave.
    double longestStep(const glm::dvec3& dirEye) const
    {
        return STEP * _waves.model.getShortestLength() /
               glm::length(surfaceFromEye(glm::dvec4(dirEye, 0.0)));
    }

private:
    const ExactWaves& _waves;
    const osg::ref_ptr<const osgWaterReflect::WaveState> _state;
    glm::dmat4 _surfaceFromEye;
    glm::dmat3 _normalEyeFromSurface;
    double _side; // 1 where the eye is above the still water, else -1
};

// A place on a line and how far it lies off the waves.
struct Sample
{
    double t;   // [world units]
    double off; // [m]
};

// The zero between two samples of different signs, by regula falsi. An end that stays is taken for
// half as far off (the Illinois rule), without which the other end would creep.
template <class Off>
double zeroBetween(Sample a, Sample b, const Off& off)
{
    for (int i = 0; i < MOST_STEPS; ++i)
    {
        const Sample middle = {(a.t * b.off - b.t * a.off) / (b.off - a.off), 0.0};
        const double middleOff = off(middle.t);
        const bool narrow = !(middle.t != a.t && middle.t != b.t);
        if (std::abs(middleOff) <= ON_WAVES || narrow) return middle.t;
        if ((middleOff > 0.0) == (b.off > 0.0))
            a.off *= 0.5;
        else
            a = b;
        b = {middle.t, middleOff};
    }
    return b.t;
}

std::optional<glm::dvec3> meet(const WavesEye& waves, const glm::dvec3& pointEye,
                               const glm::dvec3& sightDir)
{
    const auto off = [&](double t) { return waves.off(pointEye + t * sightDir); };
    Sample before = {0.0, off(0.0)};
    if (std::abs(before.off) <= ON_WAVES) return pointEye;
    const double rise = waves.rise(sightDir);
    if (!(rise < 0.0)) return std::nullopt;

    // From over the waves on down to them, from under them back toward the eye; both end, for the
    // line leaves the band in which waves are.
    const double sign = before.off > 0.0 ? 1.0 : -1.0;
    const double longest = waves.longestStep(sightDir);
    double step = std::min(2.0 * std::abs(before.off / rise), longest);
    for (int i = 0; i < MOST_STEPS; ++i)
    {
        const double t = before.t + sign * step;
        const Sample next = {t, off(t)};
        if ((next.off > 0.0) != (before.off > 0.0))
            return pointEye + zeroBetween(before, next, off) * sightDir;
        before = next;
        step = std::min(2.0 * step, longest);
    }
    return std::nullopt;
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

// What is not a number was not measured.
const double UNMEASURED = std::numeric_limits<double>::quiet_NaN();

std::optional<Percentiles> percentilesOfMeasured(std::vector<double> values)
{
    values.erase(
        std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
        values.end());
    return percentilesOf(std::move(values));
}

} // namespace

std::optional<glm::dvec3> osgwaterbench::meetWaves(const DrawnWater& drawn, const ExactWaves& waves,
                                                   const glm::dvec3& pointEye)
{
    return meet(WavesEye(drawn, waves), pointEye, sightDirEye(drawn, pointEye));
}

TessellationError
osgwaterbench::measureTessellation(const DrawnWater& drawn, const ExactWaves& exact,
                                   const osgWaterReflect::reference::SceneTracer& scene,
                                   int everyNth)
{
    const std::vector<std::size_t> pixels = waterPixels(drawn, everyNth);
    const WavesEye waves(drawn, exact);
    const ReflectionTracer tracer(drawn, scene);
    std::vector<double> heights(pixels.size());
    std::vector<double> degrees(pixels.size());
    std::vector<double> moved(pixels.size(), UNMEASURED);
    const auto measurePixel = [&](std::size_t i)
    {
        const glm::dvec3& pointEye = drawn.pointEye[pixels[i]];
        const glm::dvec3& normalEye = drawn.normalEye[pixels[i]];
        heights[i] = std::abs(waves.off(pointEye));
        degrees[i] = degreesBetween(normalEye, waves.normal(pointEye));

        const std::optional<glm::dvec3> met = meet(waves, pointEye, sightDirEye(drawn, pointEye));
        if (!met) return;
        const ReflectedPlace shown = tracer.trace(pointEye, normalEye);
        const ReflectedPlace truth = tracer.trace(*met, waves.normal(*met));
        if (shown.trueClass == TrueClass::VISIBLE && truth.trueClass == TrueClass::VISIBLE)
            moved[i] = tracer.pixels().distance(shown.placeWorld, truth.placeWorld);
    };
    inParallel(pixels.size(), measurePixel);
    return {percentilesOf(std::move(heights)), percentilesOf(std::move(degrees)),
            percentilesOfMeasured(std::move(moved))};
}
