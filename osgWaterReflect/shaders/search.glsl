// Following the ray through the captured image, column by column (row by row where it is steep).

struct TraceResult
{
    int reason;           // REASON_…
    float s;              // where on the segment, [0, 1]: of a hit, or where a ray that ended
                          // behind something went behind it
    vec3 window;          // the same place in window space [pixels, pixels, windowZ]
    float hidden;         // the ray's depth behind what hid it last [windowZ]; 0: nothing has
    bool smoothAbout;     // the four pixels about a hit are known to show one surface
};

// Columns whose centres the segment passes, from the first one after its start; the end itself
// stands for the last, of which only a part is passed.
struct Columns
{
    float first;          // s at the first centre
    float step;           // s from one to the next visited column
    int count;
};

Columns columnsOf(Capture capture, ImageRay ray, float pixelsPerStep)
{
    vec2 extent = ray.end.xy - ray.start.xy;
    bool alongX = abs(extent.x) >= abs(extent.y);
    float start = alongX ? ray.start.x : ray.start.y;
    float signedLength = alongX ? extent.x : extent.y;
    // Shorter than a hundredth of a pixel: the start's own pixel, once, over the whole segment.
    float length = max(abs(signedLength), 0.01);
    float toCentre = signedLength >= 0.0 ? floor(start + 0.5) + 0.5 - start
                                         : start - ceil(start - 0.5) + 0.5;
    // A ray that starts at the water, and leaves its pixel.
    bool startsAtWater = ray.tOverDepth.x == 0.0;
    if (startsAtWater && toCentre < 0.5 && length > 1.0) toCentre += capture.firstColumn;
    Columns columns;
    columns.first = toCentre / length;
    columns.step = pixelsPerStep / length;
    columns.count = int(max(length - toCentre, 0.0) / pixelsPerStep) + 2;
    return columns;
}

// s of a column, from 0.
float columnAt(Columns columns, int i)
{
    return min(columns.first + float(i) * columns.step, 1.0);
}

#if OSGWR_OUTPUT == OUTPUT_HIT
int depthFetches = 0;
#define COUNT_DEPTH_FETCH ++depthFetches;
#else
#define COUNT_DEPTH_FETCH
#endif

float capturedWindowZ(Capture capture, vec2 window)
{
    COUNT_DEPTH_FETCH
    return texelFetch(capture.windowZ, ivec2(window), 0).r;
}

// A surface counts as continuous from pixel to pixel up to this slope against the image plane:
// 76 degrees.
const float STEEPEST_SLOPE = 4.0;

// How far a ray may enter a body behind the edge of it that is seen, in pixels: the outermost pixel
// of a ball lies as far in front of its outline, the square root of its diameter of 256 pixels.
const float EDGE_DEPTH = 16.0;

// Depth [windowZ] of a number of pixels' sides, where the ray's 1 / depth is given.
float pixelsWindowZ(Capture capture, float pixels, float inverseDepth)
{
    return pixels * capture.pixelExtent *
           (capture.depthScale.x * inverseDepth + capture.depthScale.y);
}

// Depth [windowZ] behind a visible surface that still counts as inside it. Never less than a steep
// surface's depth grows from one pixel to the next, nor than two steps of a 24-bit depth buffer.
float thicknessWindowZ(Capture capture, float inverseDepth)
{
    float perspective = thickness * inverseDepth * inverseDepth / (1.0 + thickness * inverseDepth);
    float given = capture.depthScale.x * perspective + capture.depthScale.y * thickness;
    return max(given, pixelsWindowZ(capture, STEEPEST_SLOPE, inverseDepth)) + 1.2e-7;
}

// The surface at a place on a column's centre line: between the column's two nearest pixels.
struct Between
{
    float windowZ;
    float firstPixel;     // the lower (left) of the two [pixels]
    bool continuous;      // else it jumps there by more than its thickness: of the place's own pixel
};

//   ownZ  of the place's own pixel
Between surfaceBetween(Capture capture, vec2 window, vec2 extent, float ownZ, float thick)
{
    vec2 across = abs(extent.x) >= abs(extent.y) ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    float fraction = fract(dot(window, across)) - 0.5;
    vec2 beside = clamp(window + sign(fraction) * across, vec2(0.5), capture.size - 0.5);
    float besideZ = capturedWindowZ(capture, beside);
    Between between;
    between.continuous = abs(besideZ - ownZ) <= thick;
    between.windowZ = between.continuous ? mix(ownZ, besideZ, abs(fraction)) : ownZ;
    between.firstPixel = floor(dot(window, across) - 0.5);
    return between;
}

// Where the ray meets a surface, straight through its depths behind it at two columns.
//   s                at the second column, one step after the first
//   before, behind   depth of the ray behind the surface at the first and the second [windowZ]
//   firstShare       how far back from the second column the surface may be met [steps]
float crossing(float s, float step, float before, float behind, float firstShare)
{
    float back = behind / max(behind - before, 1e-12);
    return clamp(s - step * clamp(back, -2.0, firstShare), 0.0, 1.0);
}

// What a search by columns finds at one where the ray has reached the surface, having been in front
// of what the column before showed.
struct Meeting
{
    bool hit;
    float thick;          // of the surface [windowZ]
    float jump;           // of the surface toward the eye, from the column before [windowZ]
};

// A hit is no further behind than the surface's thickness. Where the surface has just jumped toward
// the eye, as at the edge of something in front of the ray, it must be reached within these two
// columns or just behind that edge: else the ray passes.
//   previousZ  of the surface at the column before; 0 where there was none: no jump
//   behind     depth of the ray behind the surface [windowZ]
//   stepZ      by how much the ray's windowZ changes from column to column
Meeting meetSurface(Capture capture, float surfaceZ, float previousZ, float behind, float stepZ,
                    float inverseDepth)
{
    Meeting meeting;
    meeting.thick = thicknessWindowZ(capture, inverseDepth);
    meeting.jump = previousZ - surfaceZ;
    float edge = min(pixelsWindowZ(capture, EDGE_DEPTH, inverseDepth), meeting.thick);
    meeting.hit = behind <= (meeting.jump > meeting.thick ? edge + stepZ
                                                          : meeting.thick + 0.5 * stepZ);
    return meeting;
}

// The ray at a column, and the surface it sees there.
struct Sample
{
    float s;
    float behind;         // depth of the ray behind the surface [windowZ]
};

// A hit. A surface that does not jump is met between two columns, and between their pixels.
//   before, at  the last two columns; at the first s of the former is 0, its depth not known yet
//   step        s from column to column
TraceResult hitAt(Capture capture, ImageRay ray, Meeting meeting, Sample before, Sample at,
                  float step)
{
    vec3 extent = ray.end - ray.start;
    bool continuous = meeting.jump <= meeting.thick;

    // Reached by looking ahead: rather between this column and the next.
    Sample next;
    next.s = min(at.s + step, 1.0);
    if (at.behind < 0.0 && next.s > at.s)
    {
        vec3 window = ray.start + next.s * extent;
        float ownZ = ray.start.z + at.s * extent.z - at.behind;
        float nextZ = capturedWindowZ(capture, window.xy);
        next.behind = window.z - nextZ;
        if (next.behind >= 0.0 && abs(nextZ - ownZ) <= meeting.thick)
        {
            before = at;
            at = next;
            continuous = true;
        }
    }

    TraceResult result;
    result.reason = REASON_HIT;
    result.smoothAbout = false;
    float firstShare = 0.5;
    if (continuous)
    {
        vec3 window = ray.start + at.s * extent;
        vec3 windowBefore = ray.start + before.s * extent;
        float ownZBefore = before.s > 0.0 ? windowBefore.z - before.behind
                                          : capturedWindowZ(capture, windowBefore.xy);
        Between here = surfaceBetween(capture, window.xy, extent.xy, window.z - at.behind,
                                      meeting.thick);
        Between there = surfaceBetween(capture, windowBefore.xy, extent.xy, ownZBefore,
                                       meeting.thick);
        at.behind = window.z - here.windowZ;
        before.behind = windowBefore.z - there.windowZ;
        firstShare = 2.0;
        result.smoothAbout = here.continuous && there.continuous &&
                             here.firstPixel == there.firstPixel &&
                             abs(here.windowZ - there.windowZ) <= meeting.thick;
    }
    result.s = crossing(at.s, at.s - before.s, before.behind, at.behind, firstShare);
    result.window = ray.start + result.s * extent;
    // That place may lie before the one column or beyond the other.
    result.smoothAbout = result.smoothAbout && result.s >= before.s && result.s <= at.s;
    result.hidden = 0.0;
    return result;
}

// What a search that met nothing ends with.
//   inFront          at the ray's end, of what is seen there
//   sHidden, hidden  where the ray went behind something last, and its depth behind it [windowZ]
TraceResult missOf(ImageRay ray, bool inFront, float sHidden, float hidden)
{
    TraceResult result;
    result.reason = inFront ? ray.endReason : REASON_BEHIND;
    result.s = sHidden;
    result.window = ray.start + sHidden * (ray.end - ray.start);
    result.hidden = hidden;
    result.smoothAbout = false;
    return result;
}

#if OSGWR_SEARCH == SEARCH_SEQUENTIAL
#include "search_sequential.glsl"
#elif OSGWR_SEARCH == SEARCH_HIERARCHICAL
#include "search_hierarchical.glsl"
#elif OSGWR_SEARCH == SEARCH_BINARY
#include "search_binary.glsl"
#else
#error OSGWR_SEARCH is not one of SEARCH_
#endif
