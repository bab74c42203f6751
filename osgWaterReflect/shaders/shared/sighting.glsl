// A reflected ray's search in one capture.
struct Sighting
{
    ImageRay ray;
    TraceResult result;
};

Sighting lookFor(Capture capture, vec3 originEye, vec3 dirEye)
{
    Sighting sighting;
    sighting.ray = projectRay(capture, originEye, dirEye);
    sighting.result = searchImage(capture, sighting.ray);

    // Through a wave's crest the eye sees what lies under the water; the ray in the air does not.
    // A thousandth of its length allows for the depth buffer's rounding.
    if (sighting.result.reason == REASON_HIT)
    {
        float rayLength = rayLengthAt(sighting.ray, sighting.result.s);
        vec4 hitSurface = surfaceFromEye * vec4(originEye + rayLength * dirEye, 1.0);
        float lowest = -0.001 * rayLength;
        if (eyeSide * hitSurface.z - highestWave() < lowest &&
            eyeSide * (hitSurface.z - waveHeight(hitSurface.xy)) < lowest)
            sighting.result.reason = REASON_BELOW_WATER;
    }
    return sighting;
}

// Whether the image may hide what a ray meets, or not hold it: behind what hid a ray that came out
// to the sky, too, something may stand.
bool isLost(TraceResult result)
{
    return result.reason != REASON_HIT && (result.reason != REASON_SKY || result.hidden > 0.0);
}
