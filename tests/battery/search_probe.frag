#version 130
#include "interface.glsl"

// Searches for the rays of textures, one for each pixel, and tells all about it.
//
// What follows is of single or of double precision (RayProbe.cpp). `narrow` vectors are of single
// precision in both.
uniform sampler2D probe_originEye;
uniform sampler2D probe_dirEye;
uniform sampler2D probe_disturbedOrigin;
uniform sampler2D probe_disturbedDir;
uniform sampler2D probe_disturbedStart;
uniform sampler2D probe_disturbedEnd;

int readsOutside = 0;

vec4 watchedFetch(sampler2D image, ivec2 texel, int level)
{
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(image, level))))
        ++readsOutside;
    return texelFetch(image, texel, level);
}

vec3 given(sampler2D values)
{
    return texelFetch(values, ivec2(gl_FragCoord.xy), 0).xyz;
}

#define texelFetch watchedFetch
#include "ray.glsl"
#include "search.glsl"
#undef texelFetch

out narrow4 answers[6];

void main()
{
    vec3 originEye = given(probe_originEye) + given(probe_disturbedOrigin);
    vec3 dirEye = given(probe_dirEye) + given(probe_disturbedDir);
    ImageRay ray = projectRay(eyeCapture, originEye, dirEye);
    ray.start += given(probe_disturbedStart);
    ray.end += given(probe_disturbedEnd);
    TraceResult result = searchImage(eyeCapture, ray);

    float rayLength = rayLengthAt(ray, result.s);
    answers[0] = narrow4(result.reason, depthFetches, readsOutside, result.hidden);
    answers[1] = narrow4(result.window, rayLength);
    answers[2] = narrow4(ray.skyWindow, result.endZ, result.s);
    answers[3] = narrow4(ray.start, ray.inverseDepth.x);
    answers[4] = narrow4(ray.end, ray.inverseDepth.y);
    answers[5] = narrow4(result.window - vec3(narrow3(result.window)), ray.tOverDepth.y);
}
