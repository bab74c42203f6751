#include "AutomaticChoice.h"

using namespace osgWaterReflect;

namespace
{

CaptureKind captureFor(const SceneFacts& facts)
{
    if (!facts.redrawsAlike) return CaptureKind::FRAME;
    if (facts.planes > 1) return CaptureKind::VIEW;
    if (facts.calm) return CaptureKind::MIRROR;
    return facts.bandServes ? CaptureKind::VIEW : CaptureKind::VIEW_AND_MIRROR;
}

} // namespace

WaterSettings osgWaterReflect::settle(const WaterSettings& asked, const SceneFacts& facts)
{
    WaterSettings settled = asked;
    if (asked.capture == CaptureKind::AUTOMATIC)
    {
        settled.capture = captureFor(facts);
        if (!facts.redrawsAlike) settled.guardBand = GuardBandKind::NONE;
    }
    if (asked.search == Search::AUTOMATIC) settled.search = Search::HIERARCHICAL;
    return settled;
}
