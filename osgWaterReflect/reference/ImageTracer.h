#ifndef OSGWATERREFLECT_REFERENCE_IMAGETRACER_H
#define OSGWATERREFLECT_REFERENCE_IMAGETRACER_H

#include "PlaneQ.h"

#include <vector>

namespace osgWaterReflect::reference
{

/// What an image shows, and the matrix it was taken with: any with a finite far plane.
struct CapturedImage
{
    ImageGeometry geometry;
    std::vector<float> windowZ; ///< row by row from the lower left pixel; 1 where nothing was drawn
};

/// How the search of a ray ends.
enum class ImageReason
{
    HIT,
    SKY,        ///< left through the far plane: nothing was drawn beyond
    LEFT,       ///< left the image there: passed the centres of its border pixels
    RIGHT,      ///< ...
    BOTTOM,     ///< ...
    TOP,        ///< ...
    TOWARD_EYE, ///< came to the near plane
    BEHIND      ///< ended, in whatever way, behind something that hides its end
};

/// Where the search of a ray ends.
struct ImageHit
{
    ImageReason reason = ImageReason::SKY;
    glm::dvec2 window{
        0.0};             ///< [pixels] of the hit; BEHIND: where it last went behind; else its end
    double windowZ = 0.0; ///< of the ray, there
    double t = 0.0;       ///< [world units] along the ray, there

    /// Of a hit: not on the surface that the image shows, but within the thickness behind an edge
    /// of it, on a side that the image does not show. The place is the edge's.
    bool atEdge = false;

    bool found() const { return reason == ImageReason::HIT; }
};

/// What one reflected ray meets in one captured image, by looking at every pair of pixels that the
/// ray's image passes between. The truth that the error of a faster search is measured against.
///
/// Double precision, nothing shared with the shaders, nothing skipped and nothing guessed:
///
/// - The ray is followed column by column; row by row where its image is steeper. At each, the
///   plane Q of the paper is laid through the two pixels that it passes between (PlaneQ), and the
///   ray is intersected with it.
/// - **One surface.** Two neighbours belong to the same surface where their depths (along the
///   view's axis) differ by no more than the thickness, or by what a surface 76 degrees steep
///   against the image plane gives from one pixel to the next. What the image shows at two
///   columns, where the ray passes, is compared in the same way.
/// - **Its shape.** Between two pixels of a column that belong together, and between two columns
///   that do, windowZ is linear: a plane stays one. Otherwise each ends half way to the other, its
///   windowZ kept up to there; so does what the border pixels show, outward. Background is no
///   surface.
/// - **A hit** is where the ray crosses such a surface from the front. Where a surface begins, at
///   an edge, with the ray behind it by no more than the thickness, the ray has entered a side of
///   it that the image does not show: a hit at the edge. Deeper, it passes behind, and goes on: it
///   may come out again, past the surface's other edge or through it, and meet something else.
///   While it is behind, whatever it meets is hidden and not met.
/// - The ray comes from in front of everything: if it starts inside something, that is hit at once.
class ImageTracer
{
public:
    /// thickness  [world units] above 0; how far behind a visible surface still counts as inside it
    ImageTracer(CapturedImage image, double thickness);

    /// dirEye  unit length
    ImageHit trace(const glm::dvec3& originEye, const glm::dvec3& dirEye) const;

private:
    class Walk;

    /// What the image shows at one place.
    struct Shown
    {
        double windowZ;
        double depth; ///< [world units] along the view's axis

        bool isBackground() const { return windowZ >= 1.0; }
    };

    /// Two neighbouring pixels of a column (row), between whose centres a ray passes.
    struct Pair
    {
        Shown first;
        Shown second;
    };

    Shown pixel(int x, int y) const;
    Pair pairOn(ImageLines lines, double line, double crossing) const;
    Shown between(const Pair& pair, ImageLines lines, double line, double crossing) const;
    bool belongTogether(const Shown& a, const Shown& b) const;
    double depthOf(const glm::dvec3& window) const;
    glm::dvec3 eyeFromWindow(const glm::dvec3& window) const;

    CapturedImage _image;
    double _thickness;
    glm::dmat4 _eyeFromClip;
};

} // namespace osgWaterReflect::reference

#endif
