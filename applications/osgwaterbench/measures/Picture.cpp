#include "Picture.h"

#include <glm/common.hpp>

using namespace osgwaterbench;

Picture osgwaterbench::pictureOf(const osg::Image& image)
{
    Picture picture = {image.s(), image.t(), {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
        {
            const osg::Vec4 colour =
                image.getColor(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
            picture.colours.push_back(
                glm::clamp(glm::dvec3(colour.r(), colour.g(), colour.b()), 0.0, 1.0));
        }
    return picture;
}

Picture osgwaterbench::withTruth(Picture picture, const Truth& truth)
{
    for (const TruePixel& own : truth)
        picture.colours.at(own.pixel) = glm::clamp(own.shadedColour, 0.0, 1.0);
    return picture;
}
