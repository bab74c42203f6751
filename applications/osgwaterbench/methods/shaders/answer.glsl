// What a method that stands in the place of the library's answers with; the same fields as in
// the library's reflection.glsl.
struct Reflection
{
    vec3 colour;
    int reason;           // REASON_…
    vec2 window;          // what shows that colour in the searched image [pixels]; (-1, -1): the sky does
    bool mirrored;        // false
};

Reflection answerCaptured(vec2 window)
{
    vec3 colour = finiteColour(texelFetch(eyeCapture.colour, ivec2(window), 0).rgb);
    return Reflection(colour, REASON_HIT, window, false);
}

Reflection answerSky(ImageRay ray, vec3 dirEye, int reason)
{
    return Reflection(skyColour(eyeCapture, ray, dirEye), reason, vec2(-1.0), false);
}
