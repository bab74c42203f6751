#version 130
#include "interface.glsl"

out vec4 windowZ;

// The windowZ of an ordinary projection, from that of one with an oblique near plane
// (capture/MirroredEye.h).
void main()
{
    float oblique = texelFetch(obliqueWindowZ, ivec2(gl_FragCoord.xy), 0).r;
    float straight = dot(windowZFromOblique, vec4(gl_FragCoord.xy, oblique, 1.0));
    // What was drawn is never taken for background, 1.
    windowZ = vec4(oblique < 1.0 ? min(straight, 0.9999999) : 1.0);
}
