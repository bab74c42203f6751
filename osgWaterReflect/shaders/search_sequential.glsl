// Every column in turn: the paper's sequential search. One fetch a column. Background (windowZ 1)
// is nothing to hit.
TraceResult searchImage(Capture capture, ImageRay ray)
{
    Columns columns = columnsOf(capture, ray, stride);
    vec3 extent = ray.end - ray.start;
    float stepZ = min(columns.step, 1.0) * abs(extent.z);

    bool inFront = true;
    Meeting meeting = Meeting(false, 0.0, 0.0);
    float sBefore = 0.0;   // the previous column, at first the start
    float s = 0.0;
    float surfaceZ = 0.0;  // nothing is known of the surface before the first column: no jump
    float before = 0.0;    // depth of the ray behind the surface, at the previous column [windowZ]
    float behind = 0.0;    // the same at this one
    float sHidden = 0.0;   // where the ray last went behind something ...
    float hidden = 0.0;    // ... and its depth behind that [windowZ]
    for (int i = 0; i < columns.count && !meeting.hit; ++i)
    {
        sBefore = s;
        s = columnAt(columns, i);
        vec3 window = ray.start + s * extent;
        float previousZ = surfaceZ;
        surfaceZ = capturedWindowZ(capture, window.xy);
        before = behind;
        behind = window.z - surfaceZ;
        bool reached = behind + 0.5 * stepZ >= 0.0 && surfaceZ < 1.0;
        if (reached && inFront)
        {
            meeting = meetSurface(capture, surfaceZ, previousZ, behind, stepZ,
                                  mix(ray.inverseDepth.x, ray.inverseDepth.y, s));
            if (!meeting.hit)
            {
                sHidden = s;
                hidden = behind;
            }
        }
        inFront = !reached;
    }

    if (!meeting.hit) return missOf(ray, inFront, sHidden, hidden);
    TraceResult result = hitAt(capture, ray, meeting, Sample(sBefore, before),
                               Sample(s, behind), columns.step);
    result.hidden = hidden;
    return result;
}
