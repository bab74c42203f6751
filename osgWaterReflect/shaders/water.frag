#version 130
#include "interface.glsl"
#include "waves.glsl"
#include "fresnel.glsl"
#include "ray.glsl"
#include "search.glsl"
#include "sky.glsl"
#include "sighting.glsl"
#include "reflection.glsl"
#include "reflected_ray.glsl"
#include "shade.glsl"

out vec4 fragmentColour;

void main()
{
    fragmentColour = shadeWater(pointEye, placeSurface);
}
