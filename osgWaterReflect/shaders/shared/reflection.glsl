// The colour that a reflected ray brings: found in a capture, or the sky's.

// How much deeper than what hides it a ray may be, over the depth of the latter, to be shown its
// colour. Houses and trees of a shore hide one another within half their distance; a branch ahead
// of the eye hides things many times as far.
const float HIDING_REACH = 0.5;

// How far beyond the image's border a surface seen there is taken to go on, at its windowZ, before
// the sky has taken its place [heights of the image].
const float BORDER_REACH = 0.1;

struct Reflection
{
    vec3 colour;
    int reason;           // REASON_…
    vec2 window;          // what shows that colour in its capture [pixels]; (-1, -1): the sky does,
                          // and what the image's border goes on with
    bool mirrored;        // that capture is the mirrored eye's
};

#include "trace_upsample.glsl"

vec3 capturedColour(Capture capture, vec2 window)
{
    vec2 uv = window / vec2(textureSize(capture.colour, 0));
    return finiteColour(textureLod(capture.colour, uv, 0.0).rgb);
}

// Colour of a hit whose four pixels about it do not all show the same surface: mixed of those that
// show one as deep, or else of the one that is closest in depth.
vec3 colourAmidEdges(Capture capture, ImageRay ray, TraceResult hit)
{
    float thick = thicknessWindowZ(capture, mix(ray.inverseDepth.x, ray.inverseDepth.y, hit.s));
    vec2 fraction = fract(hit.window.xy - 0.5);
    vec4 sum = vec4(0.0);
    vec3 closest = vec3(0.0);
    float closestZ = 2.0;
    // Rasterisers that run several pixels at once come here for those, too, that need none of it.
    int pixels = hit.smoothAbout ? 0 : 4;
    for (int i = 0; i < pixels; ++i)
    {
        vec2 corner = vec2(i & 1, i >> 1);
        vec2 pixel = clamp(floor(hit.window.xy - 0.5) + corner, vec2(0.0), capture.size - 1.0);
        float pixelZ = capturedWindowZ(capture, pixel);
        float apart = pixelZ < 1.0 ? abs(pixelZ - hit.window.z) : 1.0;
        vec3 colour = finiteColour(texelFetch(capture.colour, ivec2(pixel), 0).rgb);
        vec2 weights = mix(1.0 - fraction, fraction, corner);
        if (apart <= thick) sum += weights.x * weights.y * vec4(colour, 1.0);
        if (apart < closestZ)
        {
            closest = colour;
            closestZ = apart;
        }
    }
    return sum.a > 0.0 ? sum.rgb / sum.a : closest;
}

// Colour of what a search has come to: at a hit mixed of the pixels about it, else its pixel's own.
vec3 shownColour(Capture capture, Sighting sighting, vec2 window)
{
    bool hit = sighting.result.reason == REASON_HIT;
    bool smoothHit = hit && sighting.result.smoothAbout;
    vec3 colour = capturedColour(capture, smoothHit ? window : floor(window) + 0.5);
    return hit && !smoothHit ? colourAmidEdges(capture, sighting.ray, sighting.result) : colour;
}

// Share of a surface at the image's border in what is shown of a ray that has left the image there:
// all, where the ray would meet it at once, were it to go on at the same windowZ; none, where it
// would not within BORDER_REACH. So a thing that the border cuts off does not end in an edge.
float borderShare(Capture capture, ImageRay ray, float surfaceZ)
{
    vec3 extent = ray.end - ray.start;
    float room = surfaceZ - ray.end.z;
    float reachZ = extent.z / max(length(extent.xy), 1e-6) * BORDER_REACH * capture.size.y;
    bool meets = surfaceZ < 1.0 && room >= 0.0 && room < reachZ;
    return meets ? smoothstep(1.0, 0.0, room / reachZ) : 0.0;
}

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    Sighting sighting = sightingOf(eyeCapture, false, originEye, dirEye);
    ImageRay ray = sighting.ray;
    TraceResult result = sighting.result;
    bool hit = result.reason == REASON_HIT;

    // A ray that ended behind something most often met its far side or what stands close behind:
    // what hides it is seen in its place. What is much nearer to the eye is no such thing.
    bool hiddenClosely = result.reason == REASON_BEHIND &&
        result.hidden <= HIDING_REACH * eyeCapture.depthScale.x *
                         mix(ray.inverseDepth.x, ray.inverseDepth.y, result.s);
    float share = hit || hiddenClosely ? 1.0
                : leftImage(result.reason) ? borderShare(eyeCapture, ray, result.endZ)
                : 0.0;
    vec2 shown = hit || hiddenClosely ? result.window.xy : ray.end.xy;
    vec3 colour = shownColour(eyeCapture, sighting, shown);

    Reflection reflection;
    reflection.colour = colour;
    if (share < 1.0) reflection.colour = mix(skyColour(eyeCapture, ray, dirEye), colour, share);
    reflection.reason = result.reason;
    reflection.window = hit || hiddenClosely ? shown : vec2(-1.0);
    reflection.mirrored = false;

#if OSGWR_IMAGES == IMAGES_TWO
    if (mayBeMirrored(result))
    {
        Sighting mirrored = sightingOf(mirrorCapture, true, originEye, dirEye);
        if (mirrored.result.reason == REASON_HIT)
        {
            reflection.colour = shownColour(mirrorCapture, mirrored, mirrored.result.window.xy);
            reflection.reason = REASON_HIT;
            reflection.window = mirrored.result.window.xy;
            reflection.mirrored = true;
        }
    }
#elif OSGWR_IMAGES != IMAGES_ONE
#error OSGWR_IMAGES is not one of IMAGES_
#endif
    return reflection;
}
