// The mirrored camera of osgOcean, three.js and most others: what it shows at the pixel's own
// place, moved by how far the wave's normal leans from the still one. Beyond its border: the
// border's pixels. Where it shows background: the sky, in the reflected direction.
#include "answer.glsl"

uniform sampler2D bench_mirrorColour;     // of the view's size; the view starts at pixel (0, 0)
uniform sampler2D bench_mirrorWindowZ;
// How far a place is moved by a normal that lies down: everywhere [image sizes], and at a distance of
// 1, falling off with it [image sizes * world units].
uniform vec2 bench_mirrorDistortion;

// How far the normal leans, in the still plane: toward the right of the view, and away from the
// eye (up in the image).
vec2 leanOfNormal()
{
    vec3 still = eyeSide * normalize(normalEyeFromSurface * vec3(0.0, 0.0, 1.0));
    WaveSlope slope = waveSlope(placeSurface, dFdx(placeSurface), dFdy(placeSurface));
    vec3 normal = eyeSide * normalize(normalEyeFromSurface * normalOf(slope.mean));
    vec3 right = normalize(vec3(1.0, 0.0, 0.0) - still.x * still);
    vec3 away = cross(still, right);
    return vec2(dot(normal, right), dot(normal, away));
}

Reflection traceReflection(vec3 originEye, vec3 dirEye)
{
    vec2 size = vec2(textureSize(bench_mirrorColour, 0));
    float strength = bench_mirrorDistortion.x + bench_mirrorDistortion.y / length(originEye);
    vec2 window = gl_FragCoord.xy + strength * size * leanOfNormal();
    window = clamp(window, vec2(0.5), size - 0.5);

    COUNT_FETCH
    if (texelFetch(bench_mirrorWindowZ, ivec2(window), 0).r >= 1.0)
        return answerSky(projectRay(eyeCapture, originEye, dirEye), dirEye, REASON_SKY);
    vec3 colour = finiteColour(texelFetch(bench_mirrorColour, ivec2(window), 0).rgb);
    return Reflection(colour, REASON_HIT, window, false);
}
