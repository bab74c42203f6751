// Every column in turn: the paper's sequential search. One fetch a column.
//
// A hit is where the ray reaches the surface of a pixel within that pixel's column, having been in
// front of what the previous column showed, and no further behind than the surface's thickness.
// Background (windowZ 1) is nothing to hit.
TraceResult searchImage(ImageRay ray)
{
    Columns columns = columnsOf(ray);
    vec3 extent = ray.end - ray.start;
    float halfStep = 0.5 * columns.step;
    float halfStepZ = halfStep * abs(extent.z);

    bool inFront = true;
    bool hit = false;
    float s = 0.0;
    float surfaceZ = 1.0;
    for (int i = 0; i < columns.count && !hit; ++i)
    {
        s = columns.first + float(i) * columns.step;
        vec3 window = ray.start + s * extent;
        surfaceZ = capturedWindowZ(window.xy);
        bool reached = window.z + halfStepZ >= surfaceZ && surfaceZ < 1.0;
        if (reached && inFront)
        {
            float inverseDepth = mix(ray.inverseDepth.x, ray.inverseDepth.y, s);
            hit = window.z - halfStepZ <= surfaceZ + thicknessWindowZ(inverseDepth);
        }
        inFront = !reached;
    }

    float sHit = crossing(ray, s, surfaceZ, halfStep);
    TraceResult result;
    result.reason = hit ? REASON_HIT : inFront ? ray.endReason : REASON_BEHIND;
    result.s = sHit;
    result.window = ray.start.xy + sHit * extent.xy;
    return result;
}
