#ifndef OSGWATERREFLECT_TESTS_BATTERY_RAYSET_H
#define OSGWATERREFLECT_TESTS_BATTERY_RAYSET_H

#include "RayImage.h"
#include "RayProbe.h"

#include <random>
#include <string>
#include <vector>

namespace battery
{

/// Rays, and what is hard about them.
enum class RaySet
{
    ANYWHERE,   ///< from any place that the image shows, to any side
    WATER,      ///< reflected by waves on a level plane under the eye
    ALONG_AXIS, ///< along columns and rows of the image
    ONE_PLACE,  ///< toward the eye or away from it: seen in one place, or nearly
    TOWARD_EYE, ///< to the near plane, the eye's plane and behind it
    ENDLESS,    ///< parallel to the image's plane, or nearly: to a vanishing point at infinity
    GRAZING,    ///< off water that the eye is hardly above, or in
    THROUGH,    ///< from the nearest depths to the farthest, and back
    CELL_EDGES, ///< along the borders of the pyramid's cells, and through their corners
    BORDER,     ///< from the image's border, along it and out of it
    NUM
};

std::string nameOf(RaySet set);

/// Rays of a set for an image: some exact, some one, two, four … steps of single precision beside.
std::vector<Ray> createRays(RaySet set, const RayImage& image, int count, std::mt19937_64& random);

} // namespace battery

#endif
