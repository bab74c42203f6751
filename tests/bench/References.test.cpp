// The two references against each other, where screen space loses nothing: rays against the
// scene's triangles, and against the image that was captured of them.

#include "support/Catch.h"

#include <osgwaterbench/measures/ImageTruth.h>
#include <osgwaterbench/measures/Truth.h>
#include <osgwaterbench/render/Readback.h>

#include <algorithm>
#include <cmath>

using namespace osgwaterbench;

namespace
{

const glm::ivec2 SIZE(320, 240);

// Whether within 2 px of a place something nearer ends in front of something farther: a jump in
// depth of a fiftieth, more than any face of the boxes has from one pixel to the next.
bool nearSilhouette(const DrawnWater& drawn, const glm::dvec2& window)
{
    const auto& image = drawn.capture;
    double nearest = 1e9;
    double farthest = 0.0;
    for (int y = std::max(0, static_cast<int>(window.y) - 2);
         y <= std::min(SIZE.y - 1, static_cast<int>(window.y) + 2); ++y)
        for (int x = std::max(0, static_cast<int>(window.x) - 2);
             x <= std::min(SIZE.x - 1, static_cast<int>(window.x) + 2); ++x)
        {
            const double windowZ = image.windowZ[static_cast<std::size_t>(y) * SIZE.x + x];
            const double depth = -image.geometry.eyeFromWindow({x + 0.5, y + 0.5, windowZ}).z;
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    return farthest > 1.02 * nearest;
}

} // namespace

// Falls when either of them is moved by a pixel, starts from another point, or takes the thickness
// or the normal in another unit.
TEST_CASE("the two references agree but for silhouettes where screen space loses nothing")
{
    const std::optional<BenchScene> scene = createScene("boxes");
    REQUIRE(scene);
    for (const double slope : {0.0, 0.05, 0.15})
    {
        BenchView view(*scene, SIZE, BenchView::Purpose::MEASURE);
        const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves("boxes", slope);
        view.setWaves(waves);
        osgWaterReflect::WaterSettings settings = searchOfView();
        settings.guardBand = osgWaterReflect::GuardBandKind::NONE; // the view's own pixels
        view.setMethod(libraryMethod("without a band", settings));
        const DrawnWater drawn = readDrawnWater(view);
        const osgWaterReflect::reference::SceneTracer tracer(*scene->scene);
        const SkyLookup sky(glm::dvec3(0.5));
        const Truth truth = findTruth(drawn, {tracer, sky, scene->water->getOptics()});
        const ImageTruth imageTruth = findImageTruth(drawn, 0.5);
        const ViewPixels pixels(drawn);

        int compared = 0;
        int agreed = 0;
        int elsewhere = 0; // not agreed, and not at a silhouette
        for (std::size_t i = 0; i < truth.size(); ++i)
        {
            const ReflectedPlace& exact = truth[i].reflected;
            const ImagePixel& image = imageTruth[i];
            if (exact.trueClass != TrueClass::SKY && exact.trueClass != TrueClass::VISIBLE)
                continue;
            ++compared;
            const bool isPlace = exact.trueClass == TrueClass::VISIBLE;
            const bool same =
                isPlace == image.found() &&
                (!isPlace || pixels.distance(exact.placeWorld, image.placeWorld) <= MATCH_PIXELS);
            agreed += same;
            if (same) continue;
            const bool atSilhouette =
                (isPlace && nearSilhouette(drawn, exact.window)) ||
                (image.found() && nearSilhouette(drawn, pixels.window(image.placeWorld))) ||
                // The ray's end is hidden by something that it never met: it ends behind an edge.
                image.reason == osgWaterReflect::reference::ImageReason::BEHIND;
            elsewhere += !atSilhouette;
        }
        WARN("slope " << slope << ": " << compared << " pixels, " << agreed << " agree, "
                      << elsewhere << " of the others away from silhouettes");
        CHECK(compared > 30000);
        CHECK(agreed > 0.99 * compared);
        CHECK(elsewhere == 0);
    }
}
