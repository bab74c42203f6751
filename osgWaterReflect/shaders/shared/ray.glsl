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

// One bound `origin + u slope >= 0` of what the image holds. 1 / u is kept, so that a ray without end
// needs no infinity.
void clipRay(float origin, float slope, int reason,
             inout float uFirst, inout float inverseLast, inout int endReason)
{
    if (slope >= 0.0)
    {
        uFirst = max(uFirst, -origin / max(slope, 1e-30));
    }
    else
    {
        // A ray that starts on the bound and leads out ends where it starts.
        float inverse = -slope / max(origin, -1e-6 * slope);
        if (inverse > inverseLast)
        {
            inverseLast = inverse;
            endReason = reason;
        }
    }
}

// How far from the image's border rays are followed [pixels]. They start at pixels' centres: those
// along the border have as much room for their rounding.
const float BORDER_WIDTH = 0.25;

// A place of the image in window space. Where rounding leads out of it, the place on its border.
vec3 windowFromImage(Capture capture, vec3 image)
{
    vec3 window = vec3((0.5 * image.xy + 0.5) * capture.size, 1.0 - image.z);
    return clamp(window, vec3(vec2(BORDER_WIDTH), 0.0), vec3(capture.size - BORDER_WIDTH, 1.0));
}

// Every point of the ray is seen at `origin + u slope`, where u = t / clip w runs from 0 at the water
// toward 1 / (clip w of the direction) at infinity: no point is divided by a depth of its own, which
// near the eye has lost its digits, and what rounding is left bends nothing.
ImageRay projectRay(Capture capture, vec3 originEye, vec3 dirEye)
{
    vec4 a = capture.imageFromEye * vec4(originEye, 1.0);
    vec4 b = capture.imageFromEye * vec4(dirEye, 0.0);
    vec3 origin = a.xyz / a.w;
    vec3 slope = b.xyz - b.w * origin;
    vec2 border = 1.0 - 2.0 * BORDER_WIDTH / capture.size;

    float uFirst = 0.0;
    float inverseLast = max(b.w, 1e-30);
    int endReason = REASON_SKY;
    clipRay(border.x + origin.x, slope.x, REASON_LEFT, uFirst, inverseLast, endReason);
    clipRay(border.x - origin.x, -slope.x, REASON_RIGHT, uFirst, inverseLast, endReason);
    clipRay(border.y + origin.y, slope.y, REASON_BOTTOM, uFirst, inverseLast, endReason);
    clipRay(border.y - origin.y, -slope.y, REASON_TOP, uFirst, inverseLast, endReason);
    clipRay(1.0 - origin.z, -slope.z, REASON_TOWARD_EYE, uFirst, inverseLast, endReason);
    float uSky = 1.0 / inverseLast;
    clipRay(origin.z, slope.z, REASON_SKY, uFirst, inverseLast, endReason);

    // A ray that starts outside the image (rounding, at a border pixel) and never enters it stays
    // where it starts.
    bool enters = uFirst * inverseLast < 1.0;
    vec2 u = enters ? vec2(uFirst, 1.0 / inverseLast) : vec2(0.0);
    ImageRay ray;
    ray.start = windowFromImage(capture, origin + u.x * slope);
    ray.end = windowFromImage(capture, origin + u.y * slope);
    ray.inverseDepth = max(1.0 - b.w * u, 0.0) / a.w;
    ray.tOverDepth = u;
    ray.skyWindow = windowFromImage(capture, origin + uSky * slope).xy;
    ray.endReason = endReason;
    return ray;
}

// Length along the ray from its origin to the point seen at s, 0 at the segment's start, 1 at its
// end [world units]. At infinity, which single precision may take a far plane for, merely very long.
float rayLengthAt(ImageRay ray, float s)
{
    return mix(ray.tOverDepth.x, ray.tOverDepth.y, s) /
           max(mix(ray.inverseDepth.x, ray.inverseDepth.y, s), 1e-30);
}
