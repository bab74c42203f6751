#include "AccuracySteps.h"

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

using Settings = WaterSettings;

void captureOnce(Settings& settings)
{
    if (settings.capture == CaptureKind::VIEW_AND_MIRROR) settings.capture = CaptureKind::VIEW;
}

void copyFrame(Settings& settings)
{
    if (settings.capture == CaptureKind::VIEW) settings.capture = CaptureKind::FRAME;
}

void traceHalf(Settings& settings)
{
    settings.traceScale = std::min(settings.traceScale, 0.5);
}

// A mirrored capture alone has no band.
bool hasBand(const Settings& settings)
{
    return settings.capture != CaptureKind::MIRROR;
}

// Other bands do not ask for the ceiling.
void narrowBand(Settings& settings)
{
    if (hasBand(settings) && settings.guardBand == GuardBandKind::ADAPTIVE)
        settings.maxExtraPixels = std::min(settings.maxExtraPixels, 0.25);
}

void captureHalf(Settings& settings)
{
    settings.captureScale = std::min(settings.captureScale, 0.5);
}

// Its undersides are worth more than sharpness.
void copyFrameForMirror(Settings& settings)
{
    if (settings.capture == CaptureKind::MIRROR) settings.capture = CaptureKind::FRAME;
}

// A ceiling of 0 is no band already.
void traceQuarterWithoutBand(Settings& settings)
{
    settings.traceScale = std::min(settings.traceScale, 0.25);
    const bool closed =
        settings.guardBand == GuardBandKind::ADAPTIVE && settings.maxExtraPixels == 0.0;
    if (hasBand(settings) && !closed) settings.guardBand = GuardBandKind::NONE;
}

} // namespace

std::vector<Settings> osgWaterReflect::accuracySteps(const Settings& asked)
{
    std::vector<Settings> steps = {asked};
    for (const auto giveUp : {captureOnce, copyFrame, traceHalf, narrowBand, captureHalf,
                              copyFrameForMirror, traceQuarterWithoutBand})
    {
        Settings next = steps.back();
        giveUp(next);
        if (next != steps.back()) steps.push_back(next);
    }
    return steps;
}
