#pragma once

#include "Mesh.h"

#include <osg/Vec2>

namespace waterdata
{

// The ground around the lake, and the lake's bed: z over x and y. The lake's middle is the origin.
class LakeLand
{
public:
    // Levels the ground around a building; the ground's height there is the plot's from now on.
    void addPlot(const osg::Vec2& centre, float radius, float height);

    float height(const osg::Vec2& place) const;
    osg::Vec3 onGround(float x, float y, float lift = 0.0f) const;

    // How far inland, in metres; negative on the lake.
    float inland(const osg::Vec2& place) const;
    bool onPlot(const osg::Vec2& place, float margin) const;

    Mesh groundMesh() const;

    // The still water's outline, some metres behind the shoreline.
    std::vector<osg::Vec3> waterOutline() const;

private:
    struct Plot
    {
        osg::Vec2 centre;
        float radius;
        float height;
    };
    std::vector<Plot> _plots;

    float wildHeight(const osg::Vec2& place) const;
    Colour groundColour(const osg::Vec3& point, float steepness) const;
};

}
