#ifndef OSGWATERBENCH_TRUTH_H
#define OSGWATERBENCH_TRUTH_H

#include "ReflectionTracer.h"
#include "SkyLookup.h"

#include <osgWaterReflect/WaterOptics>

namespace osgwaterbench
{

/// What the reflections are of, and what the water does with them.
struct TrueWorld
{
    const osgWaterReflect::reference::SceneTracer& scene;
    const SkyLookup& sky;
    osgWaterReflect::WaterOptics optics;
};

/// What one water pixel would show, were nothing lost.
struct TruePixel
{
    std::size_t pixel = 0; ///< its number in DrawnWater
    ReflectedPlace reflected;
    glm::dvec3 reflectedColour{0.0}; ///< of the scene at that place, or of the sky
    glm::dvec3 shadedColour{0.0};    ///< the water's: with its own colour, by Fresnel's formulas
};

using Truth = std::vector<TruePixel>;

/// The truth for every water pixel of a frame, in their order: what the drawn point reflects at the
/// drawn normal, so that errors of the waves' mesh and normals are no part of it (they are
/// TessellationError's). Runs on all cores; the result does not depend on them.
///   everyNth  >= 1; only these columns and rows, for a quick look
Truth findTruth(const DrawnWater& drawn, const TrueWorld& world, int everyNth = 1);

} // namespace osgwaterbench

#endif
