#version 130
#include "interface.glsl"
#include "waves"
#include "ray.glsl"
#include "search.glsl"
#include "sky.glsl"
#include "reflection.glsl"
#include "reflected.glsl"

out vec4 foundTexel;

// What the ray of one texel of the small image has found. The normal is averaged over a pixel of
// the view, as that of the pixels about the texel is.
void main()
{
    vec3 toEye = normalize(eyePointEye.xyz - eyePointEye.w * pointEye);
    vec3 normalSurface = waveNormal(place, dFdx(place) * foundFromWindow.x,
                                    dFdy(place) * foundFromWindow.y);
    vec3 dirEye = reflectedDir(toEye, facingNormal(normalSurface, toEye));
    Sighting sighting = lookFor(eyeCapture, pointEye, dirEye);
    foundTexel = texelOf(sighting, false);
#if OSGWR_IMAGES == IMAGES_TWO
    if (isLost(sighting.result))
    {
        Sighting mirrored = lookFor(mirrorCapture, pointEye, dirEye);
        if (mirrored.result.reason == REASON_HIT)
            foundTexel = texelOf(mirrored, true);
    }
#elif OSGWR_IMAGES != IMAGES_ONE
#error OSGWR_IMAGES is not one of IMAGES_
#endif
}
