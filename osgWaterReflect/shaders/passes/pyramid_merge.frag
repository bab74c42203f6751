#version 130
#include "interface.glsl"

out vec4 bounds;

// Nearest windowZ of each larger cell, out of the cells of the level below.
void main()
{
    ivec2 size = ivec2(pyramidSourceSize);
    ivec2 first = CELLS_MERGED * ivec2(gl_FragCoord.xy);
    float nearest = 1.0;
    for (int y = 0; y < CELLS_MERGED; ++y)
        for (int x = 0; x < CELLS_MERGED; ++x)
            nearest = min(nearest, texelFetch(pyramidSource, min(first + ivec2(x, y), size - 1), 0).r);
    bounds = vec4(nearest, 0.0, 0.0, 0.0);
}
