#version 130
#include "interface.glsl"


out vec4 cells;

// All that a search asks of a smallest cell, in one texel.
void main()
{
    ivec2 cell = ivec2(gl_FragCoord.xy);
    vec2 smallest = texelFetch(pyramidSource, cell, 0).rg;
    float middle = texelFetch(pyramidMiddle, cell / CELLS_MERGED, 0).r;
    float large = texelFetch(pyramidLarge, cell / (CELLS_MERGED * CELLS_MERGED), 0).r;
    cells = vec4(smallest.r, middle, large, smallest.g);
}
