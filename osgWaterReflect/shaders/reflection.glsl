// The colour that a reflected ray brings: found in the capture, or the sky's.

// How much deeper than what hides it a ray may be, over the depth of the latter, to be shown its
// colour. Houses and trees of a shore hide one another within half their distance; a branch ahead
// of the eye hides things many times as far.
const float HIDING_REACH = 0.5;

struct Reflection
{
    vec3 colour;
    int reason;           // REASON_…
    vec2 window;          // what shows that colour in the capture [pixels]; (-1, -1): the sky does
};

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    ImageRay ray = projectRay(originEye, dirEye);
    TraceResult result = searchImage(ray);

    // Through a wave's crest the eye sees what lies under the water; the ray in the air does not.
    // A thousandth of its length allows for the depth buffer's rounding.
    if (result.reason == REASON_HIT)
    {
        float rayLength = rayLengthAt(ray, result.s);
        vec4 hitSurface = surfaceFromEye * vec4(originEye + rayLength * dirEye, 1.0);
        float heightOverWater = side * (hitSurface.z - waveHeight(hitSurface.xy));
        if (heightOverWater < -0.001 * rayLength)
            result.reason = REASON_BELOW_WATER;
    }

    // A ray that ended behind something most often met its far side or what stands close behind:
    // what hides it is seen in its place. What is much nearer to the eye is no such thing.
    bool hiddenClosely = result.reason == REASON_BEHIND &&
        result.hidden <= HIDING_REACH * captureDepthScale.x *
                         mix(ray.inverseDepth.x, ray.inverseDepth.y, result.s);

    Reflection reflection;
    reflection.reason = result.reason;
    if (result.reason == REASON_HIT || hiddenClosely)
    {
        reflection.colour = finiteColour(texelFetch(captureColour, ivec2(result.window), 0).rgb);
        reflection.window = result.window;
    }
    else
    {
        reflection.colour = skyColour(ray, dirEye);
        reflection.window = vec2(-1.0);
    }
    return reflection;
}
