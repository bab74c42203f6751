#include "WaterLook.h"

using namespace osgwaterviewer;

void WaterLook::fitTo(double modelSize)
{
    const double scale = modelSize / REFERENCE_SIZE;
    if (!thicknessGiven) reflection.thickness *= scale;
    if (!waveLengthGiven) breeze.length *= scale;
}

bool WaterLook::check() const
{
    return reflection.check() && viewSettings.check() && optics.check() && detail.check() &&
           breeze.createWaves();
}
