// The sky that the scene itself draws (a dome without depth, or the clear colour), at the place
// where the ray is last seen; where something stands there, the sky above it. Two fetches.

uniform vec3 osgwr_clearColour;

// The sky above a place that shows none, mixed of the blocks about it that have some.
vec3 skyAbove(Capture capture, vec2 window)
{
    vec2 blocks = ceil(capture.size / SKY_BLOCK);
    vec2 block = clamp(window / SKY_BLOCK, vec2(0.5), blocks - 0.5);
    COUNT_FETCH
    vec4 sky = textureLod(capture.sky, block / vec2(textureSize(capture.sky, 0)), 0.0);
    return sky.a > 0.0 ? finiteColour(sky.rgb / sky.a) : osgwr_clearColour;
}

vec3 skyColour(Capture capture, ImageRay ray, vec3 dirEye)
{
    if (capturedWindowZ(capture, ray.skyWindow) < 1.0) return skyAbove(capture, ray.skyWindow);
    COUNT_FETCH
    return finiteColour(texelFetch(capture.colour, ivec2(ray.skyWindow), 0).rgb);
}
