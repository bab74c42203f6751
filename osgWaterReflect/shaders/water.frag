#version 130
#include "interface.glsl"
#include "waves"
#include "fresnel.glsl"
#include "ray.glsl"
#include "search.glsl"
#include "sky.glsl"
#include "reflection.glsl"
#include "reflected.glsl"
#include "shade.glsl"

out vec4 fragmentColour;

void main()
{
    fragmentColour = shadeWater(pointEye, place);
}
