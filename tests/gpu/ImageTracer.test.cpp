// The water's own search against the exhaustive one, in the same captured image.

#include "support/CapturedImages.h"
#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/PositionCodes.h"
#include "support/Scenes.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/reference/ImageTracer.h>

#include <osg/ShapeDrawable>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

using namespace osgWaterReflect;
using reference::ImageHit;
using reference::ImageReason;

namespace
{

const int WIDTH = 640;
const int HEIGHT = 480;

// The debug view's colours (docs/how-it-works.md); none for what is no pixel of water, and for a
// ray that met something under the water, which no ray over calm water does.
std::optional<ImageReason> reasonOf(const osg::Vec4& colour)
{
    const struct
    {
        osg::Vec4 colour;
        ImageReason reason;
    } colours[] = {
        {{0.1f, 0.7f, 0.1f, 1}, ImageReason::HIT},
        {{0.4f, 0.7f, 1.0f, 1}, ImageReason::SKY},
        {{1.0f, 0.9f, 0.0f, 1}, ImageReason::LEFT},
        {{1.0f, 0.5f, 0.0f, 1}, ImageReason::RIGHT},
        {{0.5f, 0.3f, 0.1f, 1}, ImageReason::BOTTOM},
        {{0.6f, 0.2f, 0.8f, 1}, ImageReason::TOP},
        {{1.0f, 0.4f, 0.7f, 1}, ImageReason::TOWARD_EYE},
        {{0.8f, 0.0f, 0.0f, 1}, ImageReason::BEHIND},
    };
    for (const auto& entry : colours)
        if ((colour - entry.colour).length() < 1e-6) return entry.reason;
    return std::nullopt;
}

bool isWater(const osg::Vec4& reasonColour)
{
    // The background is black.
    return !positionCodes::isPlace(reasonColour) &&
           reasonColour.r() + reasonColour.g() + reasonColour.b() > 0.0f;
}

reference::CapturedImage imageOf(const CapturedImage& captured)
{
    reference::CapturedImage image;
    image.geometry = {fromOsg(captured.clipFromEye), glm::dvec2(WIDTH, HEIGHT)};
    const float* windowZ = reinterpret_cast<const float*>(captured.windowZ->data());
    image.windowZ.assign(windowZ, windowZ + WIDTH * HEIGHT);
    return image;
}

// Whether within 2 px of a place something nearer ends in front of something farther: a jump in
// depth of a fiftieth, more than any face of the scene has from one pixel to the next.
bool nearSilhouette(const reference::CapturedImage& image, const glm::dvec2& window)
{
    double nearest = 1e9;
    double farthest = 0.0;
    const int px = static_cast<int>(window.x);
    const int py = static_cast<int>(window.y);
    for (int y = std::max(0, py - 2); y <= std::min(HEIGHT - 1, py + 2); ++y)
        for (int x = std::max(0, px - 2); x <= std::min(WIDTH - 1, px + 2); ++x)
        {
            const double windowZ = image.windowZ[y * WIDTH + x];
            const double depth = -image.geometry.eyeFromWindow({x + 0.5, y + 0.5, windowZ}).z;
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    return farthest > 1.02 * nearest;
}

// Whether a place lies within 2 px of the image's border, where the ray leaves it.
bool nearBorder(const glm::dvec2& window)
{
    return std::min({window.x, window.y, WIDTH - window.x, HEIGHT - window.y}) < 2.0;
}

// Two searches agree on a pixel: they end for the same reason and, where they hit, within 1.5 px of
// each other (0.7 of them because the water shows the colour of a whole pixel).
struct Agreement
{
    int waterPixels = 0;
    int agreed = 0;
    int met = 0;              // something is hit, by either search
    int metAgreed = 0;        // of these
    double medianError = 0.0; // [pixels] of the hits that agree

    // Where they do not agree:
    int atEdge = 0;    // the exhaustive search hits the inside of an edge
    int atBorder = 0;  // not at a silhouette, but where the ray leaves the image
    int elsewhere = 0; // neither
    std::string kinds; // the water's reason for the true one, and how often: for a person to read
};

// Renders the boxes and calm water from a view, and traces each pixel of water.
Agreement compare(osg::Group& boxes, const osg::Vec3d& eye, double pitchDegrees)
{
    OffscreenView view(WIDTH, HEIGHT, OffscreenView::Format::RGBA32F);
    view.camera().setClearColor(osg::Vec4(0, 0, 0, 0));
    const double pitch = osg::DegreesToRadians(pitchDegrees);
    view.look(eye, eye + osg::Vec3d(0, std::cos(pitch), -std::sin(pitch)));
    positionCodes::paint(boxes);
    const osg::ref_ptr<WaterSurface> water = scenes::withoutBand(scenes::createBoxesWater());
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(&boxes);
    scene->addChild(water);

    const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
    water->setDebugView(WaterSurface::DebugView::REASON);
    const osg::ref_ptr<osg::Image> reasons = copyOf(view.render(scene));
    water->setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::ref_ptr<osg::Image> traced = copyOf(view.render(scene));

    const reference::CapturedImage image = imageOf(captured->one());
    const reference::ImageTracer tracer(image, water->getReflection().thickness);
    const glm::dmat4 eyeFromWorld = fromOsg(view.camera().getViewMatrix());
    const glm::dvec3 up(eyeFromWorld * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    const glm::dvec3 pointOnWater(eyeFromWorld[3]); // the world's origin

    Agreement result;
    std::map<std::pair<int, int>, int> kinds;
    std::vector<double> errors;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
        {
            const osg::Vec4 colour = pixel(*reasons, x, y);
            if (!isWater(colour)) continue;
            ++result.waterPixels;
            const glm::dvec3 sight =
                glm::normalize(image.geometry.eyeFromWindow({x + 0.5, y + 0.5, 0.5}));
            const double distance = glm::dot(up, pointOnWater) / glm::dot(up, sight);
            const ImageHit truth =
                tracer.trace(distance * sight, sight - 2.0 * glm::dot(up, sight) * up);

            const std::optional<ImageReason> reason = reasonOf(colour);
            bool agreed = reason == truth.reason;
            bool atSilhouette = nearSilhouette(image, truth.window);
            if (reason == ImageReason::HIT)
            {
                // The colour is that of the nearest pixel.
                const osg::Vec3d place = positionCodes::place(pixel(*traced, x, y));
                const glm::dvec2 window(image.geometry.windowFromEye(
                    glm::dvec3(eyeFromWorld * glm::dvec4(fromOsg(place), 1.0))));
                const double error = glm::length(window - truth.window);
                agreed = agreed && error <= 1.5;
                if (agreed) errors.push_back(error);
                atSilhouette = atSilhouette || nearSilhouette(image, window);
            }
            const bool met = truth.found() || reason == ImageReason::HIT;
            result.agreed += agreed;
            result.met += met;
            result.metAgreed += met && agreed;
            if (agreed) continue;
            const bool atBorder = reason != truth.reason && nearBorder(truth.window);
            result.elsewhere += !atSilhouette && !atBorder;
            result.atBorder += !atSilhouette && atBorder;
            result.atEdge += truth.atEdge;
            ++kinds[{reason ? static_cast<int>(*reason) : 8, static_cast<int>(truth.reason)}];
        }
    if (!errors.empty())
    {
        std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
        result.medianError = errors[errors.size() / 2];
    }
    std::ostringstream text;
    for (const auto& kind : kinds)
        text << ", " << kind.first.first << " for " << kind.first.second << ": " << kind.second;
    result.kinds = text.str();
    return result;
}

// Measured: 99.86 to 99.998 % of the pixels agree, 99.4 to 99.996 % of those where something is
// met. What is left lies at silhouettes, where the water's search looks at one pixel a column
// instead of two and enters no body deeper than EDGE_DEPTH; and where the ray leaves the image, in
// whose last half step the water's search still looks ahead (113 pixels meet what is just above the
// image at a pitch of 25 degrees), and where single precision may take a ray that runs along the
// border to leave through it. The bounds allow half as much again.
void check(const Agreement& result)
{
    WARN(result.waterPixels << " water pixels, " << result.agreed << " agree; " << result.met
                            << " meet something, " << result.metAgreed << " of these agree, median "
                            << result.medianError << " px; of those that do not, " << result.atEdge
                            << " are met inside an edge, " << result.atBorder
                            << " leave the image there, " << result.elsewhere
                            << " are away from silhouettes and borders; reasons" << result.kinds);
    CHECK(result.met > 10000);
    CHECK(result.agreed >= 0.998 * result.waterPixels);
    CHECK(result.metAgreed >= 0.991 * result.met);
    CHECK(result.elsewhere == 0);
}

} // namespace

// Breaks with: the half pixel left out of columnsOf (search.glsl: `floor(start + 0.5) + 0.5 -
// start` without its last 0.5).
TEST_CASE("sequential search finds what the exhaustive search finds, but at silhouettes")
{
    const struct
    {
        const char* name;
        double height;
        double pitchDegrees;
    } views[] = {{"pitch 8.6", 2.0, 8.6}, {"pitch 25", 8.0, 25.0}, {"grazing", 0.15, 0.3}};
    for (const auto& view : views)
        DYNAMIC_SECTION(view.name)
        {
            check(
                compare(*scenes::createBoxes(), osg::Vec3d(0, -2, view.height), view.pitchDegrees));
        }
}

// Breaks with: the thickness taken as infinite (search_sequential.glsl: `hit = true`).
TEST_CASE("a branch ahead of the eye does not part the two searches")
{
    const osg::ref_ptr<osg::Group> scene = scenes::createBoxes();
    scene->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 2, 2.4), 3.0, 0.3, 0.15)));
    check(compare(*scene, osg::Vec3d(0, -2, 2.0), 8.6));
}
