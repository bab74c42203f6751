// The colour of one water pixel, or what is measured there.

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
    vec3 toEye = normalize(eyePointEye.xyz - eyePointEye.w * p);
    vec3 normal = facingNormal(waveNormal(planePlace, dFdx(planePlace), dFdy(planePlace)), toEye);
    Reflection reflection = traceReflection(p, reflectedDir(toEye, normal));

#if OSGWR_OUTPUT == OUTPUT_WATER
    float eta = side > 0.0 ? refractiveIndex : 1.0 / refractiveIndex;
    float reflectance = fresnelReflectance(clamp(dot(normal, toEye), 0.0, 1.0), eta);
    return vec4(mix(waterColour, reflection.colour, reflectance), 1.0);
#elif OSGWR_OUTPUT == OUTPUT_REASON
    return vec4(reasonColour(reflection.reason), 1.0);
#elif OSGWR_OUTPUT == OUTPUT_REFLECTION
    return vec4(reflection.colour, 1.0);
#elif OSGWR_OUTPUT == OUTPUT_POINT
    return vec4(p, -1.0);
#elif OSGWR_OUTPUT == OUTPUT_NORMAL
    return vec4(normal, -1.0);
#elif OSGWR_OUTPUT == OUTPUT_HIT
    return vec4(reflection.window, reflection.reason + (reflection.mirrored ? 16 : 0), depthFetches);
#else
#error OSGWR_OUTPUT is not one of OUTPUT_
#endif
}
