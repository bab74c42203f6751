#version 130
#include "interface.glsl"
#include "waves.glsl"
#include "ray.glsl"
#include "search.glsl"
#include "sighting.glsl"
#include "reflected_ray.glsl"
#include "trace_texel.glsl"

out vec4 tracedTexel;

// Traces the ray of one texel of the small image. The normal is averaged over a pixel of
// the view, as that of the pixels about the texel is.
void main()
{
    vec3 toEye = normalize(eyePointEye.xyz - eyePointEye.w * pointEye);
    WaveSlope slope = waveSlope(placeSurface, dFdx(placeSurface) * tracedFromWindow.x,
                                dFdy(placeSurface) * tracedFromWindow.y);
    vec3 dirEye = reflectedDir(toEye, facingNormal(normalOf(slope.mean), toEye));
    Sighting sighting = lookFor(eyeCapture, pointEye, dirEye);
    tracedTexel = texelOf(sighting, false);
#if OSGWR_IMAGES == IMAGES_TWO
    if (isLost(sighting.result))
    {
        Sighting mirrored = lookFor(mirrorCapture, pointEye, dirEye);
        if (mirrored.result.reason == REASON_HIT)
            tracedTexel = texelOf(mirrored, true);
    }
#elif OSGWR_IMAGES != IMAGES_ONE
#error OSGWR_IMAGES is not one of IMAGES_
#endif
}
