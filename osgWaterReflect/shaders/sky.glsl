// What a ray sees that meets nothing.

// NaN and infinity in a captured image would spread; 65504 is the largest half float.
vec3 finiteColour(vec3 colour)
{
    return vec3(isnan(colour.r) ? 0.0 : clamp(colour.r, 0.0, 65504.0),
                isnan(colour.g) ? 0.0 : clamp(colour.g, 0.0, 65504.0),
                isnan(colour.b) ? 0.0 : clamp(colour.b, 0.0, 65504.0));
}

#if OSGWR_SKY == SKY_CUBE_MAP
vec3 skyColour(Capture capture, ImageRay ray, vec3 dirEye)
{
    return finiteColour(textureLod(skyCubeMap, worldFromEye * dirEye, 0.0).rgb);
}
#elif OSGWR_SKY == SKY_CAPTURED
// The sky that the scene itself draws (a dome without depth, or the clear colour), at the place
// where the ray is last seen; where something stands there, the nearest sky above it. The mirrored
// eye sees the world upside down.
vec3 skyColour(Capture capture, ImageRay ray, vec3 dirEye)
{
    ivec2 pixel = ivec2(ray.skyWindow);
    int up = capture.firstColumn == 0.0 ? -1 : 1;
    int last = up > 0 ? int(capture.size.y) - 1 : 0;
    while (pixel.y != last && texelFetch(capture.windowZ, pixel, 0).r < 1.0)
        pixel.y += up;
    bool background = texelFetch(capture.windowZ, pixel, 0).r >= 1.0;
    return background ? finiteColour(texelFetch(capture.colour, pixel, 0).rgb) : clearColour;
}
#else
#error OSGWR_SKY is not one of SKY_
#endif
