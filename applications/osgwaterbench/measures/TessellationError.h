#ifndef OSGWATERBENCH_TESSELLATIONERROR_H
#define OSGWATERBENCH_TESSELLATIONERROR_H

#include "Drawn.h"
#include "Percentiles.h"

#include <osgWaterReflect/WaveModel>
#include <osgWaterReflect/reference/SceneTracer.h>

namespace osgwaterbench
{

/// The waves as they are, in double precision.
struct ExactWaves
{
    const osgWaterReflect::WaveModel& model;
    double time = 0.0;              ///< [s]
    glm::dmat4 eyeFromSurface{1.0}; ///< of the water that was drawn
};

/// What is lost between the waves and what was drawn of them: by the mesh's triangles, by single
/// precision, by the shader's few Newton steps, and by normals averaged over a pixel. None of it is
/// in the other measures, which start from what was drawn.
struct TessellationError
{
    std::optional<Percentiles> height;        ///< [m] of the drawn point over or under the waves
    std::optional<Percentiles> normalDegrees; ///< [degrees] between drawn and exact normal, there

    /// [pixels] of the view between what the drawn point reflects and what the exact waves do on
    /// the same line of sight, with their own normal; of pixels where both are VISIBLE.
    std::optional<Percentiles> movedPixels;
};

/// Where the line of sight to a drawn point meets the waves, nearest to that point on the side on
/// which they lie; none where it does not come down to them. A crest nearer to the eye, which would
/// hide both, is not looked for.
std::optional<glm::dvec3> meetWaves(const DrawnWater& drawn, const ExactWaves& waves,
                                    const glm::dvec3& pointEye);

/// Runs on all cores.
///   everyNth  >= 1; only these columns and rows
TessellationError measureTessellation(const DrawnWater& drawn, const ExactWaves& waves,
                                      const osgWaterReflect::reference::SceneTracer& scene,
                                      int everyNth = 1);

} // namespace osgwaterbench

#endif
