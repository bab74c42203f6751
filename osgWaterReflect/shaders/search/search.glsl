// Following the ray through the captured image, column by column (row by row where it is steep).

struct TraceResult
{
    int reason;           // REASON_…
    float s;              // where on the segment, [0, 1]: of a hit, or where a ray that ended
                          // behind something went behind it
    vec3 window;          // the same place in window space [pixels, pixels, windowZ]
    float hidden;         // the ray's depth behind what hid it last [windowZ]; 0: nothing has
    bool smoothAbout;     // the four pixels about a hit are known to show one surface
    float endZ;           // windowZ seen where a ray has left the image
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
    float toOwnCentre = (floor(start) + 0.5 - start) * (signedLength < 0.0 ? -1.0 : 1.0);
    bool ownAhead = toOwnCentre > 0.0;
    float toCentre = ownAhead ? toOwnCentre : toOwnCentre + 1.0;
    // A ray that starts at the water, and leaves its pixel.
    bool startsAtWater = ray.tOverDepth.x == 0.0;
    if (startsAtWater && ownAhead && length > 1.0 && !capture.mirrored) toCentre += 1.0;
    // Where it may meet something in its pixel, and on calm water lies in that pixel as a whole,
    // the start itself stands for the first column.
    if (capture.mirrored) toCentre -= 1.0;
    Columns columns;
    columns.first = toCentre / length;
    columns.step = pixelsPerStep / length;
    columns.count = int(max(length - toCentre, 0.0) / pixelsPerStep) + 2;
    return columns;
}

// s of a column, in [0, 1].
float columnAt(Columns columns, int i)
{
    return clamp(columns.first + float(i) * columns.step, 0.0, 1.0);
}

#if OSGWR_OUTPUT == OUTPUT_HIT
int depthFetches = 0;
#define COUNT_FETCH ++depthFetches;
#else
#define COUNT_FETCH
#endif

float capturedWindowZ(Capture capture, vec2 window)
{
    COUNT_FETCH
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
    float perspective =
        hitThickness * inverseDepth * inverseDepth / (1.0 + hitThickness * inverseDepth);
    float given = capture.depthScale.x * perspective + capture.depthScale.y * hitThickness;
    return max(given, pixelsWindowZ(capture, STEEPEST_SLOPE, inverseDepth)) + 1.2e-7;
}

// How the surface goes on across the ray's columns, at a place on a column's centre line.
struct Across
{
    float slope;          // [windowZ] from pixel to pixel; 0 where it jumps by more than its thickness
    float firstPixel;     // the lower (left) of the two about the place [pixels]
    bool continuous;      // it does not jump between them
};

float acrossOf(vec2 window, vec2 extent)
{
    return abs(extent.x) >= abs(extent.y) ? window.y : window.x;
}

//   ownZ  of the place's own pixel
Across surfaceAcross(Capture capture, vec2 window, vec2 extent, float ownZ, float thick)
{
    float place = acrossOf(window, extent);
    float toBeside = fract(place) < 0.5 ? -1.0 : 1.0;
    vec2 beside = abs(extent.x) >= abs(extent.y) ? vec2(0.0, toBeside) : vec2(toBeside, 0.0);
    float besideZ =
        capturedWindowZ(capture, clamp(floor(window) + beside + 0.5, vec2(0.5), capture.size - 0.5));
    Across across;
    across.continuous = abs(besideZ - ownZ) <= thick;
    across.slope = across.continuous ? (besideZ - ownZ) * toBeside : 0.0;
    across.firstPixel = floor(place - 0.5);
    return across;
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

// What a place on the ray's image shows.
struct Seen
{
    float s;
    float surfaceZ;       // [windowZ]
};

// How far a search by columns has come.
//
// Its loops find the next column where a surface is reached, and nothing else: rasterisers run
// several pixels at once, and each waits in a loop for the slowest. What is found is judged between
// them.
struct Trail
{
    float lookAheadZ;     // a surface counts as reached half a column before the ray does [windowZ]
    bool inFront;         // of what the last column showed
    Sample at;            // the last column
    Sample before;        // the one that was looked at before
    Meeting meeting;
    float sHidden;        // where the ray last went behind something ...
    float hidden;         // ... and its depth behind that [windowZ]
};

vec3 windowAt(ImageRay ray, float s)
{
    return ray.start + s * (ray.end - ray.start);
}

Trail trailOf(ImageRay ray, Columns columns)
{
    Trail trail;
    trail.lookAheadZ = 0.5 * min(columns.step, 1.0) * abs(ray.end.z - ray.start.z);
    trail.inFront = true;
    trail.at = Sample(-1.0, 0.0); // none yet
    trail.before = trail.at;
    trail.meeting = Meeting(false, 0.0, 0.0);
    trail.sHidden = 0.0;
    trail.hidden = 0.0;
    return trail;
}

// Whether the ray reaches the surface that a column shows, having been in front of what the one
// before showed. Background is nothing to reach.
bool reaches(Capture capture, ImageRay ray, Columns columns, int i, inout Trail trail)
{
    float s = columnAt(columns, i);
    vec3 window = windowAt(ray, s);
    float surfaceZ = capturedWindowZ(capture, window.xy);
    trail.before = trail.at;
    trail.at = Sample(s, window.z - surfaceZ);
    bool reached = trail.at.behind + trail.lookAheadZ >= 0.0 && surfaceZ < 1.0;
    bool first = reached && trail.inFront;
    trail.inFront = !reached;
    return first;
}

// Judges what the ray has reached at a column: whether it has hit it, or passes behind.
void meet(Capture capture, ImageRay ray, Columns columns, int i, inout Trail trail)
{
    // At the first column nothing is known of the surface before: no jump.
    float sBefore = i > 0 ? columnAt(columns, i - 1) : 0.0;
    vec3 windowBefore = windowAt(ray, sBefore);
    if (trail.before.s != sBefore || i == 0)
        trail.before = Sample(sBefore, windowBefore.z - capturedWindowZ(capture, windowBefore.xy));
    float previousZ = windowBefore.z - trail.before.behind;
    float surfaceZ = windowAt(ray, trail.at.s).z - trail.at.behind;
    float inverseDepth = mix(ray.inverseDepth.x, ray.inverseDepth.y, trail.at.s);
    trail.meeting = meetSurface(capture, surfaceZ, i > 0 ? previousZ : 0.0, trail.at.behind,
                                2.0 * trail.lookAheadZ, inverseDepth);
    if (!trail.meeting.hit)
    {
        trail.sHidden = trail.at.s;
        trail.hidden = trail.at.behind;
    }
}

// Where a hit is. A surface that does not jump is met between two columns, and between their pixels.
//   next  the next column, where the ray has reached the surface by looking ahead
TraceResult hitOf(Capture capture, ImageRay ray, Columns columns, Trail trail, Seen next)
{
    vec2 extent = ray.end.xy - ray.start.xy;
    float thick = trail.meeting.thick;
    Sample before = trail.before;
    Sample at = trail.at;
    bool continuous = trail.meeting.jump <= thick;

    // Reached by looking ahead: rather between this column and the next.
    if (at.behind < 0.0)
    {
        float rayZ = windowAt(ray, next.s).z;
        float ownZ = windowAt(ray, at.s).z - at.behind;
        if (rayZ >= next.surfaceZ && abs(next.surfaceZ - ownZ) <= thick)
        {
            before = at;
            at = Sample(next.s, rayZ - next.surfaceZ);
            continuous = true;
        }
    }

    TraceResult result;
    result.reason = REASON_HIT;
    result.smoothAbout = false;
    float firstShare = 0.5;
    if (continuous)
    {
        // Both columns' pixels are cut by the surface's own plane.
        vec2 window = windowAt(ray, at.s).xy;
        vec2 windowBefore = windowAt(ray, before.s).xy;
        float ownZ = windowAt(ray, at.s).z - at.behind;
        Across across = surfaceAcross(capture, window, extent, ownZ, thick);
        at.behind -= across.slope * (fract(acrossOf(window, extent)) - 0.5);
        before.behind -= across.slope * (fract(acrossOf(windowBefore, extent)) - 0.5);
        firstShare = 2.0;
        // Nothing is known of the next column but from a step away.
        result.smoothAbout = across.continuous && distance(window, windowBefore) > 0.99 &&
                             across.firstPixel == floor(acrossOf(windowBefore, extent) - 0.5);
    }
    result.s = crossing(at.s, at.s - before.s, before.behind, at.behind, firstShare);
    result.window = windowAt(ray, result.s);
    // That place may lie before the one column or beyond the other.
    result.smoothAbout = result.smoothAbout && result.s >= before.s && result.s <= at.s;
    result.hidden = trail.hidden;
    result.endZ = 1.0;
    return result;
}

TraceResult missOf(ImageRay ray, int reason, float sHidden, float hidden, float endZ)
{
    return TraceResult(reason, sHidden, windowAt(ray, sHidden), hidden, false, endZ);
}

bool leftImage(int reason)
{
    return reason >= REASON_LEFT && reason <= REASON_TOP;
}

// What a search by columns ends with. A hit may look at the next column, a ray that leaves the image
// at its last pixel: by one fetch, for rasterisers that run several pixels at once make both.
TraceResult resultOf(Capture capture, ImageRay ray, Columns columns, Trail trail)
{
    bool hit = trail.meeting.hit;
    int ended = trail.inFront ? ray.endReason : REASON_BEHIND;
    Seen beyond = Seen(hit ? min(trail.at.s + columns.step, 1.0) : 1.0, 1.0);
    if (hit ? trail.at.behind < 0.0 : leftImage(ended))
        beyond.surfaceZ = capturedWindowZ(capture, windowAt(ray, beyond.s).xy);
    if (hit) return hitOf(capture, ray, columns, trail, beyond);
    return missOf(ray, ended, trail.sHidden, trail.hidden, beyond.surfaceZ);
}

// The search itself: TraceResult searchImage(Capture capture, ImageRay ray)
#include "search"
