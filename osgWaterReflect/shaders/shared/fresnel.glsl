// Share of unpolarised light that a smooth boundary between two transparent media reflects.
//   cosIncident  between unit normal and unit direction to the eye, [0, 1]
//   eta          refractive index beyond the boundary over that on the eye's side, > 0
// The exact dielectric form [Born99 1.5.2], total internal reflection included. Schlick's fit is
// up to 23 % too dark (at 51 degrees) for water.
float fresnelReflectance(float cosIncident, float eta)
{
    float sin2Refracted = (1.0 - cosIncident * cosIncident) / (eta * eta);
    float cosRefracted = sqrt(max(0.0, 1.0 - sin2Refracted));
    float perpendicular = (cosIncident - eta * cosRefracted) / (cosIncident + eta * cosRefracted);
    float parallel = (eta * cosIncident - cosRefracted) / (eta * cosIncident + cosRefracted);
    float reflectance = 0.5 * (perpendicular * perpendicular + parallel * parallel);
    // At grazing incidence under total reflection both quotients are 0 / 0.
    return sin2Refracted >= 1.0 ? 1.0 : reflectance;
}
