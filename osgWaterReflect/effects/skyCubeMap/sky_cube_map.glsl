// A cube map given with the water.

uniform samplerCube osgwr_skyCubeMap; // looked up with a direction in world space
uniform mat3 osgwr_worldFromEye;      // rotation

vec3 skyColour(Capture capture, ImageRay ray, vec3 dirEye)
{
    return finiteColour(textureLod(osgwr_skyCubeMap, osgwr_worldFromEye * dirEye, 0.0).rgb);
}
