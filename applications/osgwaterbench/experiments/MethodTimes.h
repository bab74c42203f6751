#ifndef OSGWATERBENCH_METHODTIMES_H
#define OSGWATERBENCH_METHODTIMES_H

#include "../render/BenchView.h"
#include "Experiments.h"
#include "ResultFile.h"
#include "Timing.h"

namespace osgwaterbench
{

/// Times methods side by side in one scene.
std::vector<CaseTime> timeMethods(const BenchScene& scene, osgWaterReflect::WaveModel* waves,
                                  const std::vector<Method>& methods, const glm::ivec2& size,
                                  int frames);

} // namespace osgwaterbench

#endif
