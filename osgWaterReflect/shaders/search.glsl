// Following the ray through the captured image, column by column (row by row where it is steep).

struct TraceResult
{
    int reason;           // REASON_…
    float s;              // of a hit: where on the segment, [0, 1]
    vec2 window;          // of a hit: where in the image [pixels]
};

// Columns whose centres the segment passes, from the first one after its start.
struct Columns
{
    float first;          // s at the first centre
    float step;           // s from one to the next visited column
    int count;
};

Columns columnsOf(ImageRay ray)
{
    vec2 extent = ray.end.xy - ray.start.xy;
    bool alongX = abs(extent.x) >= abs(extent.y);
    float start = alongX ? ray.start.x : ray.start.y;
    float signedLength = alongX ? extent.x : extent.y;
    float length = abs(signedLength);
    float toCentre = signedLength >= 0.0 ? floor(start + 0.5) + 0.5 - start
                                         : start - ceil(start - 0.5) + 0.5;
    // Half a hundredth of a pixel: the rounding of a centre that lies on the end.
    float beyond = length - toCentre + 0.005;

    Columns columns;
    if (beyond < 0.0)
    {
        // Shorter than a pixel: the start's own pixel, over the whole segment.
        columns.first = 0.5;
        columns.step = 1.0;
        columns.count = 1;
    }
    else
    {
        columns.first = toCentre / length;
        columns.step = stride / length;
        columns.count = int(beyond / stride) + 1;
    }
    return columns;
}

float capturedWindowZ(vec2 window)
{
    return texelFetch(captureWindowZ, ivec2(window), 0).r;
}

// Depth behind a visible surface, in windowZ, that still counts as inside it, where the ray's
// 1 / depth is given. Never below two steps of a 24-bit depth buffer.
float thicknessWindowZ(float inverseDepth)
{
    float t = thickness;
    float perspective = t * inverseDepth * inverseDepth / (1.0 + t * inverseDepth);
    return captureDepthScale.x * perspective + captureDepthScale.y * t + 1.2e-7;
}

// The ray's place within half a column of s at which it crosses the depth of the pixel there.
float crossing(ImageRay ray, float s, float surfaceZ, float halfStep)
{
    float slope = ray.end.z - ray.start.z;
    float exact = abs(slope) > 1e-12 ? (surfaceZ - ray.start.z) / slope : s;
    return clamp(exact, max(s - halfStep, 0.0), min(s + halfStep, 1.0));
}

#if OSGWR_SEARCH == SEARCH_SEQUENTIAL
#include "search_sequential.glsl"
#elif OSGWR_SEARCH == SEARCH_BINARY
#include "search_binary.glsl"
#else
#error OSGWR_SEARCH is not one of SEARCH_
#endif
