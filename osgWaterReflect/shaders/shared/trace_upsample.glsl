// What a pixel makes of the rays of the small image about it: with TRACE_SAMPLED it searches for
// nothing itself.

#if OSGWR_TRACE == TRACE_SAMPLED
#include "trace_texel.glsl"

// The ray of a texel; beyond the image's border that of the last one within.
TracedRay tracedRayAt(ivec2 texel)
{
    ivec2 last = textureSize(tracedRays, 0) - 1;
    return tracedRayOf(texelFetch(tracedRays, clamp(texel, ivec2(0), last), 0));
}

// The four rays of the small image about a pixel, as far as they are of the same water, and what
// they came to in one of the captures.
struct RaysAbout
{
    vec4 rayLengths;      // to hits [world units]
    vec4 weights;         // of hits; 0 where a ray has none
    float elsewhere;      // weight of hits in the other capture
    float misses;         // weight of the other rays
    TracedRay miss;       // of these the nearest; where no ray is of this water: the sky
    float fetches;        // of depths, one pixel's share
};

RaysAbout raysAbout(vec2 window, bool mirrored)
{
    vec2 texel = tracedFromWindow.xy * window + tracedFromWindow.zw - 0.5;
    vec2 fraction = fract(texel);
    RaysAbout about = RaysAbout(vec4(0.0), vec4(0.0), 0.0, 0.0,
                                TracedRay(0.0, REASON_SKY, false, 0.0, sheetNumber, 0.0), 0.0);
    float nearest = 0.0;
    float sum = 0.0;
    float fetches = 0.0;
    for (int i = 0; i < 4; ++i)
    {
        vec2 corner = vec2(i & 1, i >> 1);
        TracedRay next = tracedRayAt(ivec2(floor(texel) + corner));
        if (next.sheet != sheetNumber) continue;
        vec2 weights = mix(1.0 - fraction, fraction, corner);
        // Never 0: the one with all the weight may be of other water.
        float weight = weights.x * weights.y + 1e-3;
        sum += weight;
        fetches += weight * next.fetches;
        bool hit = next.reason == REASON_HIT;
        if (hit && next.mirrored == mirrored)
        {
            about.rayLengths[i] = next.rayLength;
            about.weights[i] = weight;
        }
        else if (hit)
        {
            about.elsewhere += weight;
        }
        else
        {
            about.misses += weight;
        }
        if (!hit && weight > nearest)
        {
            about.miss = next;
            nearest = weight;
        }
    }
    about.fetches = fetches / max(sum, 1e-3) * tracedFromWindow.x * tracedFromWindow.y;
    return about;
}

// How far along the ray's image a surface is looked for from where it is expected [pixels].
const float PIXELS_ASTRAY = 16.0;

// How many columns further than the ray beside it a ray may go behind something.
const int COLUMNS_LATER = 4;

// A place on the segment where a ray may meet what is seen there.
struct Candidate
{
    float s;
    vec3 window;
    float behind;         // depth of the ray behind the surface [windowZ]
};

// s of the point at a length along the ray; of rayLengthAt the inverse.
float segmentAt(ImageRay ray, float rayLength)
{
    float slopeT = ray.tOverDepth.y - ray.tOverDepth.x;
    float slopeDepth = ray.inverseDepth.y - ray.inverseDepth.x;
    float s = (rayLength * ray.inverseDepth.x - ray.tOverDepth.x) / (slopeT - rayLength * slopeDepth);
    return clamp(s, 0.0, 1.0);
}

Candidate candidateAt(Capture capture, ImageRay ray, float s)
{
    Candidate candidate;
    candidate.s = s;
    candidate.window = windowAt(ray, s);
    candidate.behind = candidate.window.z - capturedWindowZ(capture, candidate.window.xy);
    return candidate;
}

bool closer(Candidate a, Candidate b)
{
    return abs(a.behind) < abs(b.behind);
}

// A step of the secant method toward the surface, through the candidate and where the ray has the
// windowZ that is seen at the candidate; the candidate itself where that leads nowhere.
Candidate refined(Capture capture, ImageRay ray, Candidate at)
{
    vec3 extent = ray.end - ray.start;
    float reach = PIXELS_ASTRAY / max(max(abs(extent.x), abs(extent.y)), 1.0);
    float toDepth = at.behind / (abs(extent.z) > 1e-9 ? extent.z : 1e-9);
    Candidate second = candidateAt(capture, ray,
                                   clamp(at.s - clamp(toDepth, -reach, reach), 0.0, 1.0));
    float change = second.behind - at.behind;
    float back = at.behind * (second.s - at.s) / (abs(change) > 1e-9 ? change : 1e-9);
    Candidate third = candidateAt(capture, ray, clamp(at.s - clamp(back, -reach, reach), 0.0, 1.0));
    if (closer(second, at)) at = second;
    if (closer(third, at)) at = third;
    return at;
}

// The end of a ray that meets nothing, as that of one beside it. Where this went behind something, at
// an edge, the ray itself may do so some columns later; if it does not, it sees the sky.
TraceResult endedAs(Capture capture, ImageRay ray, TracedRay miss)
{
    bool below = miss.reason == REASON_BELOW_WATER;
    if (miss.reason != REASON_BEHIND)
    {
        int ended = below ? REASON_BELOW_WATER : ray.endReason;
        float endZ = leftImage(ended) ? capturedWindowZ(capture, ray.end.xy) : 1.0;
        return missOf(ray, ended, 0.0, 0.0, endZ);
    }

    vec3 extent = ray.end - ray.start;
    float step = 1.0 / max(max(abs(extent.x), abs(extent.y)), 1.0);
    Candidate at = candidateAt(capture, ray, segmentAt(ray, miss.rayLength));
    for (int i = 0; i < COLUMNS_LATER && at.behind < 0.0; ++i)
        at = candidateAt(capture, ray, min(at.s + step, 1.0));
    bool background = at.window.z - at.behind >= 1.0;
    return missOf(ray, background ? ray.endReason : REASON_BEHIND, at.s, miss.hidden, 1.0);
}

// Where a ray meets what the rays about it have met between two lengths, if they have; else the
// candidate unchanged.
Candidate metBetween(Capture capture, ImageRay ray, RaysAbout about, float shortest, float longest,
                     Candidate best)
{
    vec4 within = about.weights * vec4(greaterThanEqual(about.rayLengths, vec4(shortest))) *
                  vec4(lessThanEqual(about.rayLengths, vec4(longest)));
    float hits = dot(within, vec4(1.0));
    if (hits == 0.0) return best;
    float mean = segmentAt(ray, dot(within, about.rayLengths) / hits);
    Candidate candidate = refined(capture, ray, candidateAt(capture, ray, mean));
    if (closer(candidate, best)) best = candidate;
    return best;
}

// How far in front of a surface a ray that meets it may seem, in pixels: the surface is taken at
// pixel centres, and at 45 degrees to the image plane they are as far apart in depth as in it. More
// would let rays meet what they pass in front of: the reflected outline of a ball gets ragged.
const float FRONT_DEPTH = 1.0;

// Whether a candidate is a hit: no farther behind the surface than the search allows, and no farther
// in front than the surface's pixels and the ray's columns leave open.
bool isMet(Capture capture, ImageRay ray, Candidate at)
{
    float inverseDepth = mix(ray.inverseDepth.x, ray.inverseDepth.y, at.s);
    vec3 extent = ray.end - ray.start;
    float stepZ = abs(extent.z) / max(max(abs(extent.x), abs(extent.y)), 1.0);
    float thick = thicknessWindowZ(capture, inverseDepth);
    return at.behind <= min(thick, pixelsWindowZ(capture, EDGE_DEPTH, inverseDepth)) + stepZ &&
           at.behind >= -min(thick, pixelsWindowZ(capture, FRONT_DEPTH, inverseDepth) + 0.5 * stepZ);
}

// The pixel's own ray, met where the rays about it are: where these are of two things, at the nearer,
// if that is seen there, for it hides the other. Where nothing is seen near, and not all of them are
// hits, the ray ends as the nearest of the others. Nothing is searched for.
//   mirrored  that is the capture of the mirrored eye, the second to be looked at
Sighting sightingOf(Capture capture, bool mirrored, vec3 originEye, vec3 dirEye)
{
    RaysAbout about = raysAbout(gl_FragCoord.xy, mirrored);
    Sighting sighting;
    sighting.ray = projectRay(capture, originEye, dirEye);
    sighting.result = endedAs(capture, sighting.ray, about.miss);
#if OSGWR_OUTPUT == OUTPUT_HIT
    if (!mirrored) depthFetches += int(about.fetches + 0.5);
#endif
    if (about.weights == vec4(0.0)) return sighting;

    vec4 lengths = mix(about.rayLengths, vec4(1e30), equal(about.weights, vec4(0.0)));
    float shortest = min(min(lengths.x, lengths.y), min(lengths.z, lengths.w));
    float longest = max(max(about.rayLengths.x, about.rayLengths.y),
                        max(about.rayLengths.z, about.rayLengths.w));
    float middle = longest - shortest > hitThickness ? 0.5 * (shortest + longest) : longest;

    Candidate best = candidateAt(capture, sighting.ray, segmentAt(sighting.ray, shortest));
    best = metBetween(capture, sighting.ray, about, shortest, middle, best);
    bool met = isMet(capture, sighting.ray, best);
    bool apart = middle < longest;
    if (!met && apart)
    {
        best = metBetween(capture, sighting.ray, about, middle, longest, best);
        met = isMet(capture, sighting.ray, best);
    }
    bool otherEnds = about.misses > 0.0 || (!mirrored && about.elsewhere > 0.0);
    if (!met && otherEnds) return sighting;

    // Many pixels may be met at one edge: what the four captured pixels there show is not known.
    sighting.result = TraceResult(REASON_HIT, best.s, best.window, 0.0, false, 1.0);
    return sighting;
}

// Whether what the first capture tells of a ray leaves room for a hit in the second: what that shows
// is decided by those about it.
bool mayBeMirrored(TraceResult result)
{
    return result.reason != REASON_HIT;
}
#elif OSGWR_TRACE == TRACE_HERE
Sighting sightingOf(Capture capture, bool mirrored, vec3 originEye, vec3 dirEye)
{
    return lookFor(capture, originEye, dirEye);
}

bool mayBeMirrored(TraceResult result)
{
    return isLost(result);
}
#else
#error OSGWR_TRACE is not one of TRACE_
#endif
