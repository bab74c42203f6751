#ifndef OSGWATERBENCH_DRAWN_H
#define OSGWATERBENCH_DRAWN_H

#include <osgWaterReflect/reference/ImageTracer.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgwaterbench
{

/// What a frame drew at its water pixels, read back. Its pixels are numbered row by row from the
/// lower left one, y * width + x; every vector has as many elements as the view has pixels.
struct DrawnWater
{
    /// The view itself, in whose pixels every error is given, and the matrix that it was drawn
    /// with.
    osgWaterReflect::reference::ImageGeometry view;
    glm::dmat4 eyeFromWorld{1.0}; ///< rigid

    /// What the water's search looked at: of another size, and wider by a guard band, where the
    /// method has it so. Needed by findImageTruth() only.
    osgWaterReflect::reference::CapturedImage capture;

    std::vector<std::uint8_t> isWater; ///< 0 or 1
    std::vector<glm::dvec3> pointEye;  ///< the displaced water point that was drawn
    std::vector<glm::dvec3> normalEye; ///< unit normal that it was shaded with, facing the eye
    glm::dvec3 stillNormalEye{0.0};    ///< unit normal of the still water, on the eye's side

    int width() const { return static_cast<int>(view.size.x); }
    int height() const { return static_cast<int>(view.size.y); }
};

/// What one method answered at one water pixel.
struct Answer
{
    bool sky = true;            ///< the sky is shown
    glm::dvec3 placeWorld{0.0}; ///< else the place in the scene whose colour is shown
    float fetches = 0.0f;       ///< depth fetches
};

/// One for each pixel of the view; what stands at those without water is not looked at.
using Answers = std::vector<Answer>;

/// The numbers of the water pixels, in order.
///   everyNth  >= 1; only these columns and rows are looked at
std::vector<std::size_t> waterPixels(const DrawnWater& drawn, int everyNth = 1);

} // namespace osgwaterbench

#endif
