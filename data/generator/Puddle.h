#pragma once

#include <osg/Vec2>
#include <osg/Vec3>

#include <vector>

namespace waterdata
{

// A shallow dent in the asphalt; the water in it stands at z = 0.
class Puddle
{
public:
    explicit Puddle(const osg::Vec2& centre) : _centre(centre) {}

    // The asphalt's height: a little above the water all around, and below it in the dent.
    float asphaltHeight(const osg::Vec2& place) const;

    // Where the asphalt closes over the water's edge; concave.
    std::vector<osg::Vec3> waterOutline() const;

private:
    osg::Vec2 _centre;

    float shoreDistance(float angle) const;
};

}
