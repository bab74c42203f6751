// Following the ray through the captured image, column by column (row by row where it is steep).

struct TraceResult
{
    int reason;           // REASON_…
    float s;              // where on the segment, [0, 1]: of a hit, or where a ray that ended
                          // behind something went behind it
    vec2 window;          // the same place in the image [pixels]
    float hidden;         // its depth behind the surface there [windowZ]
};

// Columns whose centres the segment passes, from the first one after its start; the end itself
// stands for the last, of which only a part is passed.
struct Columns
{
    float first;          // s at the first centre
    float step;           // s from one to the next visited column
    int count;
};

Columns columnsOf(ImageRay ray, float pixelsPerStep)
{
    vec2 extent = ray.end.xy - ray.start.xy;
    bool alongX = abs(extent.x) >= abs(extent.y);
    float start = alongX ? ray.start.x : ray.start.y;
    float signedLength = alongX ? extent.x : extent.y;
    // Shorter than a hundredth of a pixel: the start's own pixel, once, over the whole segment.
    float length = max(abs(signedLength), 0.01);
    float toCentre = signedLength >= 0.0 ? floor(start + 0.5) + 0.5 - start
                                         : start - ceil(start - 0.5) + 0.5;
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

float capturedWindowZ(vec2 window)
{
    COUNT_DEPTH_FETCH
    return texelFetch(captureWindowZ, ivec2(window), 0).r;
}

// A surface counts as continuous from pixel to pixel up to this slope against the image plane:
// 76 degrees.
const float STEEPEST_SLOPE = 4.0;

// How far a ray may enter a body behind the edge of it that is seen, in pixels: the outermost pixel
// of a ball lies as far in front of its outline, the square root of its diameter of 256 pixels.
const float EDGE_DEPTH = 16.0;

// Depth [windowZ] of a number of pixels' sides, where the ray's 1 / depth is given.
float pixelsWindowZ(float pixels, float inverseDepth)
{
    return pixels * capturePixelExtent *
           (captureDepthScale.x * inverseDepth + captureDepthScale.y);
}

// Depth [windowZ] behind a visible surface that still counts as inside it. Never less than a steep
// surface's depth grows from one pixel to the next, nor than two steps of a 24-bit depth buffer.
float thicknessWindowZ(float inverseDepth)
{
    float perspective = thickness * inverseDepth * inverseDepth / (1.0 + thickness * inverseDepth);
    float given = captureDepthScale.x * perspective + captureDepthScale.y * thickness;
    return max(given, pixelsWindowZ(STEEPEST_SLOPE, inverseDepth)) + 1.2e-7;
}

// windowZ of the surface at a place on a column's centre line: between the column's two nearest
// pixels, unless the surface jumps there by more than its thickness.
float surfaceBetween(vec2 window, vec2 extent, float thick)
{
    vec2 across = abs(extent.x) >= abs(extent.y) ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    float fraction = fract(dot(window, across)) - 0.5;
    vec2 beside = clamp(window + sign(fraction) * across, vec2(0.5), captureSize - 0.5);
    float ownZ = capturedWindowZ(window);
    float besideZ = capturedWindowZ(beside);
    return abs(besideZ - ownZ) > thick ? ownZ : mix(ownZ, besideZ, abs(fraction));
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
Meeting meetSurface(float surfaceZ, float previousZ, float behind, float stepZ, float inverseDepth)
{
    Meeting meeting;
    meeting.thick = thicknessWindowZ(inverseDepth);
    meeting.jump = previousZ - surfaceZ;
    float edge = min(pixelsWindowZ(EDGE_DEPTH, inverseDepth), meeting.thick);
    meeting.hit = behind <= (meeting.jump > meeting.thick ? edge + stepZ
                                                          : meeting.thick + 0.5 * stepZ);
    return meeting;
}

// The place of a hit. A surface that does not jump is met between these two columns, and between
// their pixels.
//   sBefore, s      at the two columns
//   before, behind  depth of the ray behind the surface there [windowZ]
float placeOfHit(ImageRay ray, Meeting meeting, float sBefore, float s, float before, float behind)
{
    float firstShare = 0.5;
    if (meeting.jump <= meeting.thick)
    {
        vec3 extent = ray.end - ray.start;
        vec3 window = ray.start + s * extent;
        vec3 windowBefore = ray.start + sBefore * extent;
        behind = window.z - surfaceBetween(window.xy, extent.xy, meeting.thick);
        before = windowBefore.z - surfaceBetween(windowBefore.xy, extent.xy, meeting.thick);
        firstShare = 2.0;
    }
    return crossing(s, s - sBefore, before, behind, firstShare);
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
