#version 130
#include "interface.glsl"

out vec4 bounds;

// Nearest and farthest windowZ of each smallest cell of the capture.
void main()
{
    ivec2 size = ivec2(pyramidSourceSize);
    ivec2 first = CELL * ivec2(gl_FragCoord.xy);
    float nearest = 1.0;
    float farthest = 0.0;
    for (int y = 0; y < CELL; ++y)
        for (int x = 0; x < CELL; ++x)
        {
            // At the image's border the last pixels stand for those that are missing.
            float windowZ = texelFetch(pyramidSource, min(first + ivec2(x, y), size - 1), 0).r;
            nearest = min(nearest, windowZ);
            farthest = max(farthest, windowZ);
        }
    bounds = vec4(nearest, farthest, 0.0, 0.0);
}
