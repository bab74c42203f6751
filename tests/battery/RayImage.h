#ifndef OSGWATERREFLECT_TESTS_BATTERY_RAYIMAGE_H
#define OSGWATERREFLECT_TESTS_BATTERY_RAYIMAGE_H

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <random>
#include <string>
#include <vector>

namespace battery
{

/// What a captured image can show, from the plainest to what no scene would.
enum class Shown
{
    PLANE,      ///< windowZ linear over the image, beyond [0, 1] cut off
    SPHERES,    ///< before the background
    STEPS,      ///< bands of constant windowZ
    COMB,       ///< columns of one pixel before the background
    CHECKERS,   ///< pixels in turn near and far
    NOISE,      ///< each pixel's own
    NEAR,       ///< 0 everywhere
    BACKGROUND, ///< 1 everywhere
    NUM
};

/// How an image was taken.
enum class Lens
{
    PERSPECTIVE,
    WIDE,     ///< 170 degrees
    NARROW,   ///< 0.1 degrees
    DEEP,     ///< far over near is 1e9
    ENDLESS,  ///< no far plane at all
    OFF_AXIS, ///< and turned left for right, as a mirrored eye's
    ORTHOGRAPHIC,
    NUM
};

/// An image of depths to look for rays in, and all that a search asks of a capture.
struct RayImage
{
    std::string name;           ///< what it shows, and how
    glm::ivec2 size{1};         ///< [pixels]
    std::vector<float> windowZ; ///< row by row from the lower left pixel
    glm::dmat4 clipFromEye{1.0};
    double nearest = 0.1;     ///< depth at windowZ 0 and
    double farthest = 1000.0; ///< at windowZ 1 [world units]; very far where there is no far plane
    bool mirrored = false;    ///< a ray may meet something in its own pixel
    double thickness = 0.5;   ///< [world units]
    double stride = 1.0;      ///< [pixels]

    bool isOrthographic() const { return clipFromEye[2][3] == 0.0; }

    /// What the shader is given: clip space as osgWaterReflect::imageFromClip() has it.
    glm::mat4 imageFromEye() const;

    glm::dvec3 eyeFromWindow(const glm::dvec3& window) const;
    glm::dvec3 windowFromEye(const glm::dvec3& eye) const;

    /// How windowZ changes with depth, and a pixel's side: what a capture says of itself.
    glm::dvec2 depthScale() const;
    double pixelExtent() const;
};

/// bits  of a depth buffer whose steps windowZ is rounded to; 32: single precision
RayImage createImage(Shown shown, Lens lens, int bits, const glm::ivec2& size,
                     std::mt19937_64& random);

} // namespace battery

#endif
