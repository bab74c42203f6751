// Every column in turn: the paper's sequential search. One fetch a column.
//
// A hit is where the ray reaches the surface of a pixel within that pixel's column, having been in
// front of what the previous column showed, and no further behind than the surface's thickness.
// Where the surface has just jumped toward the eye, as at the edge of something in front of the
// ray, it must be reached within these two columns or just behind that edge: else the ray passes.
// Background (windowZ 1) is nothing to hit.
TraceResult searchImage(ImageRay ray)
{
    Columns columns = columnsOf(ray);
    vec3 extent = ray.end - ray.start;
    float stepZ = min(columns.step, 1.0) * abs(extent.z);

    bool inFront = true;
    bool hit = false;
    float sBefore = 0.0;   // the previous column, at first the start
    float s = 0.0;
    float surfaceZ = 0.0;  // nothing is known of the surface before the first column: no jump
    float before = 0.0;    // depth of the ray behind the surface, at the previous column [windowZ]
    float behind = 0.0;    // the same at this one
    float jump = 0.0;      // of the surface toward the eye, from the previous column [windowZ]
    float thick = 0.0;
    float sHidden = 0.0;   // where the ray last went behind something ...
    float hidden = 0.0;    // ... and its depth behind that [windowZ]
    for (int i = 0; i < columns.count && !hit; ++i)
    {
        sBefore = s;
        s = columnAt(columns, i);
        vec3 window = ray.start + s * extent;
        float previousZ = surfaceZ;
        surfaceZ = capturedWindowZ(window.xy);
        jump = previousZ - surfaceZ;
        before = behind;
        behind = window.z - surfaceZ;
        bool reached = behind + 0.5 * stepZ >= 0.0 && surfaceZ < 1.0;
        if (reached && inFront)
        {
            float inverseDepth = mix(ray.inverseDepth.x, ray.inverseDepth.y, s);
            thick = thicknessWindowZ(inverseDepth);
            float edge = min(pixelsWindowZ(EDGE_DEPTH, inverseDepth), thick);
            hit = behind <= (jump > thick ? edge + stepZ : thick + 0.5 * stepZ);
            sHidden = s;
            hidden = behind;
        }
        inFront = !reached;
    }

    // A surface that does not jump is met between these two columns, and between their pixels.
    float firstShare = 0.5;
    if (hit && jump <= thick)
    {
        vec3 window = ray.start + s * extent;
        vec3 windowBefore = ray.start + sBefore * extent;
        behind = window.z - surfaceBetween(window.xy, extent.xy, thick);
        before = windowBefore.z - surfaceBetween(windowBefore.xy, extent.xy, thick);
        firstShare = 2.0;
    }

    TraceResult result;
    result.reason = hit ? REASON_HIT : inFront ? ray.endReason : REASON_BEHIND;
    result.s = hit ? crossing(s, s - sBefore, before, behind, firstShare) : sHidden;
    result.hidden = hidden;
    result.window = ray.start.xy + result.s * extent.xy;
    return result;
}
