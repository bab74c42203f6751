// The ray that a pixel of water reflects to the eye.

// Unit normal in eye space, on the eye's side, turned just enough to face the eye: a pixel of
// water that is seen faces the eye, whatever a wave's averaged normal says.
vec3 facingNormal(vec3 normalSurface, vec3 toEye)
{
    vec3 normal = eyeSide * normalize(normalEyeFromSurface * normalSurface);
    float facing = dot(normal, toEye);
    return facing < 0.0 ? normalize(normal - facing * toEye) : normal;
}

// A ray that a wave sends down meets water at once: it is followed as reflected once more, by
// still water.
vec3 reflectedDir(vec3 toEye, vec3 normal)
{
    vec3 still = eyeSide * normalize(normalEyeFromSurface * vec3(0.0, 0.0, 1.0));
    vec3 reflected = reflect(-toEye, normal);
    return reflected - 2.0 * min(dot(reflected, still), 0.0) * still;
}
