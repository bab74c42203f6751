#pragma once

#include "Mesh.h"

namespace waterdata
{

// One afternoon for all scenes and for the sky: the sky pictures are turned to this sun.
struct Daylight
{
    osg::Vec3 towardsSun;
    Colour sunLight;
    Colour zenithLight;
    Colour horizonLight;
    Colour groundLight;
    Colour haze;
    float hazeDistance;
};

Daylight afternoon();

// The linear light of a painted (sRGB) colour, and back with a soft shoulder for the brightest.
Colour toLinear(const Colour& painted);
Colour toPainted(const Colour& linear);

// The far away fades into the haze; measured from the middle of the scene.
Colour throughHaze(const Colour& painted, float distance, const Daylight& daylight);

}
