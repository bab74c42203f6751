// The search of Li and Luo, literally [LiLuo], for perspective views. In each image column the two
// pixels between which the ray passes are thrown back into space by their depths. They span the
// plane Q with the eye, and the ray is intersected with it. The ray has hit where that place is not
// nearer to the eye than what the ray's own pixel shows: D_m >= D, both measured from the eye.
// However far behind it is. Background is nothing to hit.
#include "answer.glsl"
#include "image_columns.glsl"
#include "eye_depth.glsl"

// The inverse of a perspective projection, off axis too.
vec3 eyeFromWindow(vec2 window, float windowZ)
{
    vec2 ndc = 2.0 * window / eyeCapture.size - 1.0;
    vec2 offAxis = vec2(eyeCapture.imageFromEye[2][0], eyeCapture.imageFromEye[2][1]);
    vec2 scale = vec2(eyeCapture.imageFromEye[0][0], eyeCapture.imageFromEye[1][1]);
    return eyeDepthAt(windowZ) * vec3((ndc + offAxis) / scale, -1.0);
}

// Whether the ray is behind what is seen where it crosses a column (row). Two fetches.
bool isBehind(vec2 crossing, bool alongX, vec3 originEye, vec3 dirEye)
{
    vec2 across = alongX ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    float between = dot(crossing, across);
    float first = clamp(floor(between - 0.5) + 0.5, 0.5, dot(eyeCapture.size, across) - 1.5);
    vec2 firstPixel = alongX ? vec2(crossing.x, first) : vec2(first, crossing.y);
    vec2 secondPixel = firstPixel + across;
    float firstZ = capturedWindowZ(eyeCapture, firstPixel);
    float secondZ = capturedWindowZ(eyeCapture, secondPixel);
    vec3 firstEye = eyeFromWindow(firstPixel, firstZ);
    vec3 secondEye = eyeFromWindow(secondPixel, secondZ);

    vec3 normalQ = cross(firstEye, secondEye);
    float t = -dot(normalQ, originEye) / dot(normalQ, dirEye);
    float rayDistance = length(originEye + t * dirEye);
    bool ownIsFirst = between - first < 0.5;
    float sceneDistance = length(ownIsFirst ? firstEye : secondEye);
    return rayDistance >= sceneDistance && (ownIsFirst ? firstZ : secondZ) < 1.0;
}

// The first column, by the order of its search, where the ray is behind; none: count.
//   int searchColumns(ImageColumns columns, vec3 originEye, vec3 dirEye)
#include "paper_search.glsl"

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    // From the pixel's own place to where the ray, followed for ever, is last seen.
    ImageRay ray = projectRay(eyeCapture, originEye, dirEye);
    vec4 start = eyeCapture.imageFromEye * vec4(originEye, 1.0);
    vec2 startWindow = windowFromImage(eyeCapture, start.xyz / start.w).xy;
    ImageColumns columns = columnsBetween(startWindow, ray.skyWindow);
    int found = searchColumns(columns, originEye, dirEye);
    if (found == columns.count) return answerSky(ray, dirEye, ray.endReason);
    return answerCaptured(crossingAt(columns, found));
}
