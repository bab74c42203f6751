// The colour that a reflected ray brings: found in the capture, or the sky's.

struct Reflection
{
    vec3 colour;
    int reason;           // REASON_…
};

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    ImageRay ray = projectRay(originEye, dirEye);
    TraceResult result = searchImage(ray);

    // Through a wave's crest the eye sees what lies under the water; the ray in the air does not.
    // A thousandth of its length allows for the depth buffer's rounding.
    float rayLength = rayLengthAt(ray, result.s);
    vec4 hitSurface = surfaceFromEye * vec4(originEye + rayLength * dirEye, 1.0);
    float heightOverWater = side * (hitSurface.z - waveHeight(hitSurface.xy));
    if (result.reason == REASON_HIT && heightOverWater < -0.001 * rayLength)
        result.reason = REASON_BELOW_WATER;

    Reflection reflection;
    reflection.reason = result.reason;
    if (result.reason == REASON_HIT)
        reflection.colour = finiteColour(textureLod(captureColour, result.window / captureSize, 0.0).rgb);
    else
        reflection.colour = skyColour(ray, dirEye);
    return reflection;
}
