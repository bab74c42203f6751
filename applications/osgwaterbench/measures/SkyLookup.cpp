#include "SkyLookup.h"

#include <osg/Image>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

using namespace osgwaterbench;

namespace
{

struct FacePlace
{
    int face;
    glm::dvec2 st; // [0, 1]
};

// Table 8.19 of OpenGL 4.6. Where two axes are as long, OpenGL leaves the choice open.
FacePlace facePlaceOf(const glm::dvec3& dir)
{
    const glm::dvec3 length = glm::abs(dir);
    int face = 0;
    glm::dvec2 sc(0.0);
    double ma = 0.0;
    if (length.x >= length.y && length.x >= length.z)
    {
        face = dir.x >= 0.0 ? osg::TextureCubeMap::POSITIVE_X : osg::TextureCubeMap::NEGATIVE_X;
        sc = glm::dvec2(dir.x >= 0.0 ? -dir.z : dir.z, -dir.y);
        ma = length.x;
    }
    else if (length.y >= length.z)
    {
        face = dir.y >= 0.0 ? osg::TextureCubeMap::POSITIVE_Y : osg::TextureCubeMap::NEGATIVE_Y;
        sc = glm::dvec2(dir.x, dir.y >= 0.0 ? dir.z : -dir.z);
        ma = length.y;
    }
    else
    {
        face = dir.z >= 0.0 ? osg::TextureCubeMap::POSITIVE_Z : osg::TextureCubeMap::NEGATIVE_Z;
        sc = glm::dvec2(dir.z >= 0.0 ? dir.x : -dir.x, -dir.y);
        ma = length.z;
    }
    return {face, sc / ma * 0.5 + 0.5};
}

} // namespace

SkyLookup::SkyLookup(const glm::dvec3& colour)
{
    for (Face& face : _faces)
        face.texels[0] = glm::vec3(colour);
}

SkyLookup::SkyLookup(const osg::TextureCubeMap& cubeMap)
{
    for (unsigned int i = 0; i < _faces.size(); ++i)
    {
        const osg::Image* image = cubeMap.getImage(i);
        if (!image) continue;
        Face& face = _faces[i];
        face.side = image->s();
        face.texels.clear();
        for (int t = 0; t < face.side; ++t)
            for (int s = 0; s < face.side; ++s)
            {
                const osg::Vec4 colour =
                    image->getColor(static_cast<unsigned int>(s), static_cast<unsigned int>(t));
                face.texels.emplace_back(colour.r(), colour.g(), colour.b());
            }
    }
}

glm::dvec3 SkyLookup::colour(const glm::dvec3& dirWorld) const
{
    const FacePlace place = facePlaceOf(dirWorld);
    const Face& face = _faces[place.face];
    // Texel centres lie at halves.
    const glm::dvec2 uv = place.st * static_cast<double>(face.side) - 0.5;
    const glm::dvec2 lower = glm::floor(uv);
    const glm::dvec2 share = uv - lower;
    const auto texel = [&face, &lower](int s, int t)
    {
        const int column = std::clamp(static_cast<int>(lower.x) + s, 0, face.side - 1);
        const int row = std::clamp(static_cast<int>(lower.y) + t, 0, face.side - 1);
        return glm::dvec3(face.texels[static_cast<std::size_t>(row) * face.side + column]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x),
                    glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}
