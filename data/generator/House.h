#pragma once

#include "Mesh.h"

namespace waterdata
{

struct HouseStyle
{
    float width = 9.0f;
    float depth = 7.0f;
    int storeys = 2;
    float storeyHeight = 2.7f;
    float roofHeight = 3.0f;
    int windowsAcross = 4;
    int windowsDeep = 2;
    Colour wall = colour(0xa8382c);
    Colour trim = colour(0xf4f1ea);
    Colour roof = colour(0x55504e);
    Colour door = colour(0x2f4a3c);
    bool chimney = true;
    bool porch = false;
};

// A gabled house on z = 0: its front looks along -y, its ridge runs along x.
void addHouse(Mesh& mesh, const HouseStyle& style);

// A window or door in the plane y = 0 of the mesh's frame, looking along -y, centred on x = 0.
void addWindow(Mesh& mesh, float width, float height, const Colour& trim, int panesAcross = 2);
void addDoor(Mesh& mesh, float width, float height, const Colour& trim, const Colour& leaf);

// A roof over the rectangle of the given size, its eaves at z = 0.
void addGableRoof(Mesh& mesh, float width, float depth, float height, const Colour& paint,
                  const Colour& verge);

// A church: a nave and, at its western end, a steeple.
void addChurch(Mesh& mesh);

}
