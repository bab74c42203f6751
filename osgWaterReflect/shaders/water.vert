#version 130
#include "interface.glsl"
#include "waves.glsl"

// The mesh lies in the still plane, in surface coordinates about an anchor near the eye; waves
// move it up and down only, so that a shore's edge stays where it is.
void main()
{
    placeSurface = gl_Vertex.xy;
    vec4 displaced = vec4(placeSurface, waveHeight(placeSurface), 1.0);
    pointEye = (gl_ModelViewMatrix * displaced).xyz;
    gl_Position = gl_ProjectionMatrix * vec4(pointEye, 1.0);
}
