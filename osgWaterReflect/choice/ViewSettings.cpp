#include "ViewSettings.h"

#include "AccuracySteps.h"

#include <osg/Camera>
#include <osg/Notify>

#include <algorithm>
#include <mutex>

using namespace osgWaterReflect;

namespace
{

// The band is not known to serve before the view has been captured.
ViewFacts factsOf(const std::vector<SeenWater>& seen)
{
    ViewFacts facts;
    facts.bandServes = false;
    std::vector<CaptureEye> planes;
    for (const SeenWater& each : seen)
    {
        if (each.water->getReflection().capture != CaptureKind::AUTOMATIC) continue;
        const WaveModel* const waves = each.water->getWaves();
        facts.calm = facts.calm && !(waves && waves->getMaxSlope() > 0.0);
        for (const CaptureEye& eye : each.mirroredEyes)
            if (std::none_of(planes.begin(), planes.end(),
                             [&](const CaptureEye& plane) { return serveTogether(plane, eye); }))
                planes.push_back(eye);
    }
    facts.planes = static_cast<int>(planes.size());
    return facts;
}

void sayCopied(const std::string& technique)
{
    static std::once_flag said;
    std::call_once(said,
                   [&]
                   {
                       OSG_NOTICE << "osgWaterReflect: " << technique
                                  << " has other shadows each time a scene is drawn. Water with "
                                     "CaptureKind::AUTOMATIC reflects the frame itself there, "
                                     "without a guard band."
                                  << std::endl;
                   });
}

std::vector<ReflectionSettings> stepsOf(const WaterSurface& water, const ViewFacts& facts)
{
    return accuracySteps(settle(water.getReflection(), facts));
}

} // namespace

ReflectionSettings ViewSettings::of(osgUtil::CullVisitor& view, const WaterSurface& water)
{
    const ReflectionSettings& asked = water.getReflection();
    const bool timed = asked.frameTimeTarget > 0.0;
    if (asked.capture != CaptureKind::AUTOMATIC && !timed) return settle(asked, ViewFacts());
    if (!_seen) _seen = look(view);
    if (!timed) return settle(asked, _seen->facts);
    const std::vector<ReflectionSettings> steps = stepsOf(water, _seen->facts);
    return steps[std::min<std::size_t>(_seen->step, steps.size() - 1)];
}

ViewSettings::Seen ViewSettings::look(osgUtil::CullVisitor& view)
{
    if (!_finder) _finder = new WaterFinder;
    const std::vector<SeenWater>& waters = _finder->find(view);
    Seen seen;
    seen.facts = factsOf(waters);
    seen.facts.redrawsAlike = _finder->unsteadyShadows().empty();
    if (!seen.facts.redrawsAlike) sayCopied(_finder->unsteadyShadows());
    double target = 0.0; // [ms]
    std::size_t numSteps = 1;
    for (const SeenWater& each : waters)
    {
        const double own = each.water->getReflection().frameTimeTarget;
        if (own == 0.0) continue;
        target = target == 0.0 ? own : std::min(target, own);
        numSteps = std::max(numSteps, stepsOf(*each.water, seen.facts).size());
    }
    if (target > 0.0)
        seen.step =
            FramePace::of(*view.getCurrentCamera())
                .step(view.getTraversalNumber(), target / 1000.0, static_cast<int>(numSteps));
    return seen;
}
