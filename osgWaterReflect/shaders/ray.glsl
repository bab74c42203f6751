// The reflected ray as the capture sees it. A projective map takes lines to lines: the ray is a
// straight segment in window space, and windowZ is linear along it. This line is the
// intersection with the paper's plane Q, in closed form (docs/how-it-works.md).

// How a search ends.
#define REASON_HIT 0
#define REASON_SKY 1           // left through the far plane: nothing was drawn beyond
#define REASON_LEFT 2          // left the image through its left side ...
#define REASON_RIGHT 3
#define REASON_BOTTOM 4
#define REASON_TOP 5
#define REASON_TOWARD_EYE 6    // came to the near plane
#define REASON_BEHIND 7        // ended behind something that hides it
#define REASON_BELOW_WATER 8   // met something under the water, seen through a wave's crest

struct ImageRay
{
    vec3 start;           // window space: pixels, windowZ
    vec3 end;
    vec2 inverseDepth;    // 1 / clip w at start and end [1 / world unit], linear along the segment
    vec2 tOverDepth;      // t / clip w at start and end, linear along the segment
    vec2 skyWindow;       // where the ray, followed for ever, is last seen in the image [pixels]
    int endReason;        // what the ray comes to at its end
};

// One half space `origin + t slope >= 0` of the image's frustum. 1 / t is kept, so that a ray
// without end needs no infinity.
void clipRay(float origin, float slope, int reason,
             inout float tFirst, inout float inverseLast, inout int endReason)
{
    if (slope > 0.0)
    {
        tFirst = max(tFirst, -origin / slope);
    }
    else if (slope < 0.0)
    {
        // A ray that starts on the border and leads out ends where it starts.
        float inverse = -slope / max(origin, -1e-6 * slope);
        if (inverse > inverseLast)
        {
            inverseLast = inverse;
            endReason = reason;
        }
    }
}

vec3 windowFromClip(Capture capture, vec4 clip)
{
    return (0.5 * clip.xyz / clip.w + 0.5) * vec3(capture.size, 1.0);
}

ImageRay projectRay(Capture capture, vec3 originEye, vec3 dirEye)
{
    vec4 a = capture.clipFromEye * vec4(originEye, 1.0);
    vec4 b = capture.clipFromEye * vec4(dirEye, 0.0);
    // The centres of the border pixels bound what can be read. A ray that may meet something in its
    // own pixel needs room there for its rounding: half as much again.
    vec2 border = 1.0 - (0.5 + 0.5 * capture.firstColumn) / capture.size;

    float tFirst = 0.0;
    float inverseLast = 0.0;
    int endReason = REASON_SKY;
    clipRay(border.x * a.w + a.x, border.x * b.w + b.x, REASON_LEFT, tFirst, inverseLast, endReason);
    clipRay(border.x * a.w - a.x, border.x * b.w - b.x, REASON_RIGHT, tFirst, inverseLast, endReason);
    clipRay(border.y * a.w + a.y, border.y * b.w + b.y, REASON_BOTTOM, tFirst, inverseLast, endReason);
    clipRay(border.y * a.w - a.y, border.y * b.w - b.y, REASON_TOP, tFirst, inverseLast, endReason);
    clipRay(a.w + a.z, b.w + b.z, REASON_TOWARD_EYE, tFirst, inverseLast, endReason);
    vec4 skyClip = inverseLast * a + b;
    clipRay(a.w - a.z, b.w - b.z, REASON_SKY, tFirst, inverseLast, endReason);

    ImageRay ray;
    // A start outside the image (rounding, at a border pixel) must not pass the end.
    vec4 startClip = tFirst * inverseLast < 1.0 ? a + tFirst * b : a;
    vec4 endClip = inverseLast * a + b;
    ray.start = windowFromClip(capture, startClip);
    ray.end = windowFromClip(capture, endClip);
    ray.inverseDepth = vec2(1.0 / startClip.w, inverseLast / endClip.w);
    ray.tOverDepth = vec2(tFirst / startClip.w, 1.0 / endClip.w);
    ray.skyWindow = skyClip.w > 0.0 ? windowFromClip(capture, skyClip).xy : ray.start.xy;
    ray.endReason = endReason;
    return ray;
}

// Length along the ray from its origin to the point seen at s, 0 at the segment's start, 1 at its
// end [world units].
float rayLengthAt(ImageRay ray, float s)
{
    return mix(ray.tOverDepth.x, ray.tOverDepth.y, s) / mix(ray.inverseDepth.x, ray.inverseDepth.y, s);
}
