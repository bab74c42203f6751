#version 130
#include "interface.glsl"

out vec4 sky;

// From one place that is looked at to the next [pixels].
const float SKY_STEP = 4.0;

// For the centre of each block of a capture the colour of the background nearest above it
// (images/SkyImage.h). The way up is straight: it leads to the vanishing point of that direction.
void main()
{
    vec2 at = min(SKY_BLOCK * gl_FragCoord.xy, skySourceSize - 0.5);
    vec2 toUp = (skyUp.xy - skyUp.z * (2.0 * at / skySourceSize - 1.0)) * skySourceSize;
    float length = max(abs(toUp.x), abs(toUp.y));
    vec2 up = SKY_STEP * toUp / max(length, 1e-30);
    sky = vec4(0.0);
    float places = length > 0.0 ? max(skySourceSize.x, skySourceSize.y) / SKY_STEP + 2.0 : 1.0;
    for (float i = 0.0; i < places && sky.a == 0.0; i += 1.0)
    {
        vec2 place = at + i * up;
        bool inside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, skySourceSize));
        ivec2 pixel = ivec2(clamp(place, vec2(0.0), skySourceSize - 0.5));
        bool background = texelFetch(skySourceWindowZ, pixel, 0).r >= 1.0;
        if (inside && background) sky = vec4(texelFetch(skySourceColour, pixel, 0).rgb, 1.0);
    }
}
