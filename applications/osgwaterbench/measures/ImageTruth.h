#ifndef OSGWATERBENCH_IMAGETRUTH_H
#define OSGWATERBENCH_IMAGETRUTH_H

#include "Drawn.h"

namespace osgwaterbench
{

/// What an exhaustive search of the captured image finds at one water pixel.
struct ImagePixel
{
    std::size_t pixel = 0; ///< its number in DrawnWater
    osgWaterReflect::reference::ImageReason reason = osgWaterReflect::reference::ImageReason::SKY;
    glm::dvec3 placeWorld{0.0}; ///< of a HIT

    bool found() const { return reason == osgWaterReflect::reference::ImageReason::HIT; }
};

using ImageTruth = std::vector<ImagePixel>;

/// The best that a search of the captured image can do, for every water pixel in their order: the
/// same rays as findTruth() follows, searched by ImageTracer. Runs on all cores.
///   thickness  [world units] > 0; how far behind a visible surface still counts as inside it
///   everyNth   >= 1; only these columns and rows
ImageTruth findImageTruth(const DrawnWater& drawn, double thickness, int everyNth = 1);

} // namespace osgwaterbench

#endif
