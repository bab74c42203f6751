#include "MethodTimes.h"

using namespace osgwaterbench;

std::vector<CaseTime> osgwaterbench::timeMethods(const BenchScene& scene,
                                                 osgWaterReflect::WaveModel* waves,
                                                 const std::vector<Method>& methods,
                                                 const glm::ivec2& size, int frames)
{
    BenchView view(scene, size, BenchView::Purpose::TIME);
    view.setWaves(waves);
    std::vector<TimedCase> cases;
    for (const Method& method : methods)
        cases.push_back({method.name, [&view, &method] { view.setMethod(method); },
                         [&view] { return view.time(); }});
    return timeSideBySide(cases, frames);
}
