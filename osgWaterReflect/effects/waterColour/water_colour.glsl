// The same colour wherever the water is looked into [LiLuo].

uniform vec3 osgwr_waterColour;

vec3 bodyColour(WaterPixel pixel)
{
    return osgwr_waterColour;
}
