// A sum of trochoidal (Gerstner) waves in deep water, asked by the place where the surface is,
// not by the place where the water particle rests [Tessendorf01 3].
//
// A particle resting at r is found at  p = r + D(r),  D = -sum d_i a_i sin(theta_i),
// at the height  sum a_i cos(theta_i) + rise,  theta_i = k_i . r + phase_i.

// The rest place of the particle found at p. D is the gradient of a potential and the steepness
// sum is under 1, so p - D has one root; Newton's steps reach it. The error by steepness and
// number of steps is measured in docs/waves.md.
vec2 restPlace(vec2 p)
{
    vec2 rest = p;
    for (int step = 0; step < waveIterations; ++step)
    {
        vec2 displacement = vec2(0.0);
        vec3 jacobian = vec3(1.0, 1.0, 0.0); // xx, yy, xy of I + dD/dr
        for (int i = 0; i < waveCount; ++i)
        {
            vec2 k = waves[i].xy;
            float theta = dot(k, rest) + waves[i].w;
            vec2 direction = normalize(k);
            float a = waves[i].z;
            displacement -= direction * (a * sin(theta));
            float c = a * cos(theta);
            jacobian -= c * vec3(k.x * direction.x, k.y * direction.y, k.x * direction.y);
        }
        vec2 residual = p - rest - displacement;
        float determinant = jacobian.x * jacobian.y - jacobian.z * jacobian.z;
        vec2 newton = vec2(jacobian.y * residual.x - jacobian.z * residual.y,
                           jacobian.x * residual.y - jacobian.z * residual.x) / determinant;
        rest += newton;
    }
    return rest;
}

// Height above the still level [m].
float waveHeight(vec2 p)
{
    vec2 rest = restPlace(p);
    float height = waveRise;
    for (int i = 0; i < waveCount; ++i)
        height += waves[i].z * cos(dot(waves[i].xy, rest) + waves[i].w);
    return height;
}

// Share of a wave's amplitude left after averaging over a pixel's footprint: a Gaussian of half a
// pixel's standard deviation leaves exp(-variance / 2) of a sine. Far waves turn smooth instead
// of noisy.
float pixelAverage(vec2 k, vec2 dPdx, vec2 dPdy)
{
    vec2 phasePerPixel = vec2(dot(k, dPdx), dot(k, dPdy));
    return exp(-0.125 * dot(phasePerPixel, phasePerPixel));
}

// Unit normal in surface space, averaged over the pixel whose sides are dPdx and dPdy [m];
// pass zero for the normal at the point itself.
vec3 waveNormal(vec2 p, vec2 dPdx, vec2 dPdy)
{
    vec2 rest = restPlace(p);
    vec2 gradient = vec2(0.0);           // of the height, by the rest place
    vec3 jacobian = vec3(1.0, 1.0, 0.0);
    for (int i = 0; i < waveCount; ++i)
    {
        vec2 k = waves[i].xy;
        float theta = dot(k, rest) + waves[i].w;
        vec2 direction = normalize(k);
        float a = waves[i].z * pixelAverage(k, dPdx, dPdy);
        gradient -= k * (a * sin(theta));
        float c = a * cos(theta);
        jacobian -= c * vec3(k.x * direction.x, k.y * direction.y, k.x * direction.y);
    }
    // slope = inverse(jacobian) * gradient; the determinant, above 0, goes into the z component.
    float determinant = jacobian.x * jacobian.y - jacobian.z * jacobian.z;
    return normalize(vec3(jacobian.z * gradient.y - jacobian.y * gradient.x,
                          jacobian.z * gradient.x - jacobian.x * gradient.y, determinant));
}
