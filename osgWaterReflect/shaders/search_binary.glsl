// The paper's binary search: halve the segment by whether its middle is behind the surface seen
// there. About log2(n) fetches for n columns; but `behind` is not monotone along a ray, so hits
// are missed (docs/how-it-works.md gives the share).
TraceResult searchImage(ImageRay ray)
{
    vec3 extent = ray.end - ray.start;
    float columns = max(abs(extent.x), abs(extent.y));

    float sFront = 0.0;
    float sBehind = 1.0;
    float surfaceZ = 1.0;
    for (float width = columns; width > 0.5; width *= 0.5)
    {
        float s = 0.5 * (sFront + sBehind);
        vec3 window = ray.start + s * extent;
        float z = capturedWindowZ(window.xy);
        bool behind = window.z >= z && z < 1.0;
        sFront = behind ? sFront : s;
        sBehind = behind ? s : sBehind;
        surfaceZ = behind ? z : surfaceZ;
    }

    // The last place behind a surface is a hit if the ray came no further than its thickness.
    float halfStep = 0.5 / max(columns, 1.0);
    float inverseDepth = mix(ray.inverseDepth.x, ray.inverseDepth.y, sBehind);
    float z = ray.start.z + sBehind * extent.z - halfStep * abs(extent.z);
    bool found = surfaceZ < 1.0;
    bool hit = found && z <= surfaceZ + thicknessWindowZ(inverseDepth);

    float sHit = crossing(ray, sBehind, surfaceZ, halfStep);
    TraceResult result;
    result.reason = hit ? REASON_HIT : found ? REASON_BEHIND : ray.endReason;
    result.s = sHit;
    result.window = ray.start.xy + sHit * extent.xy;
    return result;
}
