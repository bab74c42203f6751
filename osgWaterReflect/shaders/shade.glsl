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

// Unit normal in eye space, on the eye's side, turned just enough to face the eye: a pixel of
// water that is seen faces the eye, whatever a wave's averaged normal says.
vec3 facingNormal(vec3 normalSurface, vec3 toEye)
{
    vec3 normal = side * normalize(normalEyeFromSurface * normalSurface);
    float facing = dot(normal, toEye);
    return facing < 0.0 ? normalize(normal - facing * toEye) : normal;
}

vec4 shadeWater(vec3 p, vec2 planePlace)
{
    vec3 toEye = normalize(eyePointEye.xyz - eyePointEye.w * p);
    vec3 still = side * normalize(normalEyeFromSurface * vec3(0.0, 0.0, 1.0));
    vec3 normal = facingNormal(waveNormal(planePlace, dFdx(planePlace), dFdy(planePlace)), toEye);

    // A ray that a wave sends down meets water at once: it is followed as reflected once more,
    // by still water.
    vec3 reflected = reflect(-toEye, normal);
    reflected -= 2.0 * min(dot(reflected, still), 0.0) * still;
    Reflection reflection = traceReflection(p, reflected);

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
