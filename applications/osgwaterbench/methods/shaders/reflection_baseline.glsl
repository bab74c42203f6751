// The plain way that most screen-space reflections start from, for perspective views: one pixel a
// column (row), and a hit where the ray at the column's centre is behind that pixel by no more than
// the thickness, in depths along the view's axis. Background is nothing to hit.
#include "answer.glsl"
#include "image_columns.glsl"
#include "eye_depth.glsl"

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    // From the pixel's own place on.
    ImageRay ray = projectRay(eyeCapture, originEye, dirEye);
    vec4 start = eyeCapture.imageFromEye * vec4(originEye, 1.0);
    vec2 startWindow = windowFromImage(eyeCapture, start.xyz / start.w).xy;
    ImageColumns columns = columnsBetween(startWindow, ray.end.xy);
    for (int i = 0; i < columns.count; ++i)
    {
        vec2 window = crossingAt(columns, i);
        float windowZ = capturedWindowZ(eyeCapture, window);
        float rayDepth =
            1.0 / mix(1.0 / start.w, ray.inverseDepth.y, shareAt(columns, i));
        float behind = rayDepth - eyeDepthAt(windowZ);
        if (windowZ < 1.0 && behind >= 0.0 && behind <= hitThickness) return answerCaptured(window);
    }
    return answerSky(ray, dirEye, ray.endReason);
}
