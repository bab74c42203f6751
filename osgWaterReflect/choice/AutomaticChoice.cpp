#include "AutomaticChoice.h"

using namespace osgWaterReflect;

namespace
{

CaptureKind captureFor(const ViewFacts& facts)
{
    if (!facts.redrawsAlike) return CaptureKind::FRAME;
    if (facts.planes > 1) return CaptureKind::VIEW;
    if (facts.calm) return CaptureKind::MIRROR;
    return facts.bandServes ? CaptureKind::VIEW : CaptureKind::VIEW_AND_MIRROR;
}

} // namespace

ReflectionSettings osgWaterReflect::settle(const ReflectionSettings& asked, const ViewFacts& facts)
{
    ReflectionSettings settled = asked;
    if (asked.capture == CaptureKind::AUTOMATIC)
    {
        settled.capture = captureFor(facts);
        if (!facts.redrawsAlike) settled.guardBand = GuardBandKind::NONE;
    }
    if (asked.search == Search::AUTOMATIC) settled.search = Search::HIERARCHICAL;
    return settled;
}
