#pragma once

#include "Mesh.h"

namespace waterdata
{

struct FacadeStyle
{
    float width = 6.5f;
    int storeys = 3;
    int windows = 3;
    Colour wall = colour(0xd9c9a8);
    Colour trim = colour(0xf2eee4);
    Colour shop = colour(0x2f5a4a);
    Colour awning = colour(0xb5372d);
    Colour roof = colour(0x7d4636);
    bool gabled = false;
    bool hasAwning = true;
};

// A town house with a shop; its front, in the plane y = 0 and from x = 0 to its width, looks along
// -y. Walls and details are apart, for walls show shadows and need the finer triangles.
void addFacade(Mesh& walls, Mesh& details, const FacadeStyle& style);

float facadeHeight(const FacadeStyle& style);

}
