// What a ray sees that meets nothing.

// NaN and infinity in a captured image would spread; 65504 is the largest half float.
vec3 finiteColour(vec3 colour)
{
    return vec3(isnan(colour.r) ? 0.0 : clamp(colour.r, 0.0, 65504.0),
                isnan(colour.g) ? 0.0 : clamp(colour.g, 0.0, 65504.0),
                isnan(colour.b) ? 0.0 : clamp(colour.b, 0.0, 65504.0));
}

// The sky in the unit direction of a ray: vec3 skyColour(Capture capture, ImageRay ray, vec3 dirEye)
#include "sky"
