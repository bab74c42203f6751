// The colour of one water pixel, or what is measured there.

struct WaterPixel
{
    vec3 point;           // of the water's surface, in eye space
    WaveSlope slope;
    vec3 toEye;           // unit direction to the eye, in eye space
    vec3 normal;          // of unit length, in eye space, on the eye's side
};

// What is seen of the water where it does not reflect: vec3 bodyColour(WaterPixel pixel)
#include "body"

// What lies on top of that and of the reflection: vec3 NAME(WaterPixel pixel, vec3 colour) for each
#include "over"

#if OSGWR_OUTPUT == OUTPUT_REASON
// The debug view's colours, by reason; the table stands in docs/how-it-works.md too.
vec3 reasonColour(int reason)
{
    if (reason == REASON_HIT) return vec3(0.1, 0.7, 0.1);         // green
    if (reason == REASON_SKY) return vec3(0.4, 0.7, 1.0);         // light blue
    if (reason == REASON_LEFT) return vec3(1.0, 0.9, 0.0);        // yellow
    if (reason == REASON_RIGHT) return vec3(1.0, 0.5, 0.0);       // orange
    if (reason == REASON_BOTTOM) return vec3(0.5, 0.3, 0.1);      // brown
    if (reason == REASON_TOP) return vec3(0.6, 0.2, 0.8);         // violet
    if (reason == REASON_TOWARD_EYE) return vec3(1.0, 0.4, 0.7);  // pink
    if (reason == REASON_BEHIND) return vec3(0.8, 0.0, 0.0);      // red
    return vec3(0.0, 0.2, 0.5);                                   // below the water: dark blue
}
#endif

vec4 shadeWater(vec3 p, vec2 planePlace)
{
    WaterPixel pixel;
    pixel.point = p;
    pixel.toEye = normalize(eyePointEye.xyz - eyePointEye.w * p);
    pixel.slope = waveSlope(planePlace, dFdx(planePlace), dFdy(planePlace));
    pixel.normal = facingNormal(normalOf(pixel.slope.mean), pixel.toEye);
    Reflection reflection = traceReflection(p, reflectedDir(pixel.toEye, pixel.normal));

#if OSGWR_OUTPUT == OUTPUT_WATER
    float eta = eyeSide > 0.0 ? waterRefractiveIndex : 1.0 / waterRefractiveIndex;
    float reflectance = fresnelReflectance(clamp(dot(pixel.normal, pixel.toEye), 0.0, 1.0), eta);
    vec3 colour = mix(bodyColour(pixel), reflection.colour, reflectance);
#each "over" colour = over(pixel, colour);
    return vec4(colour, 1.0);
#elif OSGWR_OUTPUT == OUTPUT_REASON
    return vec4(reasonColour(reflection.reason), 1.0);
#elif OSGWR_OUTPUT == OUTPUT_REFLECTION
    return vec4(reflection.colour, 1.0);
#elif OSGWR_OUTPUT == OUTPUT_POINT
    return vec4(p, -1.0);
#elif OSGWR_OUTPUT == OUTPUT_NORMAL
    return vec4(pixel.normal, -1.0);
#elif OSGWR_OUTPUT == OUTPUT_HIT
    return vec4(reflection.window, reflection.reason + (reflection.mirrored ? 16 : 0), depthFetches);
#else
#error OSGWR_OUTPUT is not one of OUTPUT_
#endif
}
