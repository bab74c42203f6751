#ifndef OSGWATERBENCH_PICTURE_H
#define OSGWATERBENCH_PICTURE_H

#include "Truth.h"

#include <osg/Image>

namespace osgwaterbench
{

/// A picture, row by row from the lower left pixel.
struct Picture
{
    int width = 0;                   ///< [pixels]
    int height = 0;                  ///< [pixels]
    std::vector<glm::dvec3> colours; ///< each channel [0, 1], 1 is 255 of 8 bits; not rounded
};

/// Copies an image of any format that osg::Image::getColor() reads; what is out of [0, 1] is drawn
/// into it, as by an 8-bit frame buffer.
Picture pictureOf(const osg::Image& image);

/// A frame's picture with the true colours at the truth's pixels: at all of the water only where
/// the truth was found for all.
Picture withTruth(Picture picture, const Truth& truth);

} // namespace osgwaterbench

#endif
