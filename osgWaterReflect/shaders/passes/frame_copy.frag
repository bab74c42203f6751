#version 130
#include "interface.glsl"

out vec4 colour;

// The frame's pixels, in the projection of the capture.
void main()
{
    ivec2 pixel = ivec2(frameFromCapture.xy + frameFromCapture.zw * gl_FragCoord.xy);
    colour = texelFetch(frameColour, pixel, 0);
    float windowZ = texelFetch(frameWindowZ, pixel, 0).r;
    gl_FragDepth = windowZ < 1.0 ? 1.0 - (captureFarGap.x + captureFarGap.y * (1.0 - windowZ)) : 1.0;
}
