// The paper's binary search: halve the segment by whether its middle is behind the surface seen
// there. About log2(n) fetches for n columns; but `behind` is not monotone along a ray, so hits
// are missed (docs/how-it-works.md gives the share).
TraceResult searchImage(Capture capture, ImageRay ray)
{
    vec3 extent = ray.end - ray.start;
    float columns = max(abs(extent.x), abs(extent.y));

    float sFront = 0.0;
    float sBehind = 1.0;
    float before = -1.0;  // depth of the ray behind the surface, at sFront [windowZ]
    float behind = -1.0;  // the same at sBehind
    float surfaceFront = 0.0;
    float surfaceBehind = 1.0;
    // In its own pixel, which on calm water may hold all of it, a ray is looked at by its two ends.
    if (capture.mirrored)
    {
        surfaceFront = capturedWindowZ(capture, ray.start.xy);
        before = ray.start.z - surfaceFront;
        surfaceBehind = capturedWindowZ(capture, ray.end.xy);
        behind = ray.end.z - surfaceBehind;
    }
    for (float width = columns; width > 0.5; width *= 0.5)
    {
        float s = 0.5 * (sFront + sBehind);
        vec3 window = ray.start + s * extent;
        float surfaceZ = capturedWindowZ(capture, window.xy);
        float depth = window.z - surfaceZ;
        if (depth >= 0.0 && surfaceZ < 1.0)
        {
            sBehind = s;
            behind = depth;
            surfaceBehind = surfaceZ;
        }
        else
        {
            sFront = s;
            before = depth;
            surfaceFront = surfaceZ;
        }
    }

    // The nearest place behind a surface is a hit if the ray came no further than its thickness.
    bool found = behind >= 0.0 && surfaceBehind < 1.0;
    float step = sBehind - sFront;
    float thick = thicknessWindowZ(capture, mix(ray.inverseDepth.x, ray.inverseDepth.y, sBehind));
    bool hit = found && behind <= thick + step * abs(extent.z);
    float firstShare = surfaceFront - surfaceBehind > thick ? 0.5 : 2.0;

    // Behind something else a ray may have come out again.
    float endZ = capturedWindowZ(capture, ray.end.xy);
    bool endsBehind = found && ray.end.z >= endZ && endZ < 1.0;

    TraceResult result;
    result.reason = hit ? REASON_HIT : endsBehind ? REASON_BEHIND : ray.endReason;
    result.s = crossing(sBehind, step, before, behind, firstShare);
    result.hidden = behind;
    result.endZ = endZ;
    result.smoothAbout = false;
    result.window = ray.start + result.s * extent;
    return result;
}
