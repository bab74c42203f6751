// No search at all: every ray sees the sky.
#include "answer.glsl"

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    return answerSky(projectRay(eyeCapture, originEye, dirEye), dirEye, REASON_SKY);
}
