#include "MirrorTruth.h"

#include "OffscreenView.h"
#include "PositionCodes.h"

#include <algorithm>
#include <cmath>
#include <vector>

using osgWaterReflect::WaterSurface;

namespace
{

const int WIDTH = 640;
const int HEIGHT = 480;
const osg::Vec4 HIT(0.1f, 0.7f, 0.1f, 1.0f); // the debug view's green

// Reflection in a plane, for row vectors.
osg::Matrixd mirrorMatrix(const osg::Plane& plane)
{
    const osg::Vec3d n = plane.getNormal();
    const double d = plane[3];
    return osg::Matrixd(1 - 2 * n.x() * n.x(), -2 * n.x() * n.y(), -2 * n.x() * n.z(), 0,
                        -2 * n.y() * n.x(), 1 - 2 * n.y() * n.y(), -2 * n.y() * n.z(), 0,
                        -2 * n.z() * n.x(), -2 * n.z() * n.y(), 1 - 2 * n.z() * n.z(), 0,
                        -2 * d * n.x(), -2 * d * n.y(), -2 * d * n.z(), 1);
}

// A picture of places and the matrices it was taken with (for row vectors, as OSG's).
struct PlacePicture
{
    osg::ref_ptr<osg::Image> image;
    osg::Matrixd eyeFromWorld;
    osg::Matrixd clipFromEye;

    // Window coordinates [pixels] and eye depth of a place.
    osg::Vec3d window(const osg::Vec3d& place) const
    {
        const osg::Vec3d placeEye = place * eyeFromWorld;
        const osg::Vec4d clip = osg::Vec4d(placeEye, 1.0) * clipFromEye;
        return osg::Vec3d((0.5 * clip.x() / clip.w() + 0.5) * WIDTH,
                          (0.5 * clip.y() / clip.w() + 0.5) * HEIGHT, -placeEye.z());
    }

    double depthAt(int x, int y) const
    {
        const osg::Vec4 colour = pixel(*image, x, y);
        return positionCodes::isPlace(colour) ? window(positionCodes::place(colour)).z() : 1e9;
    }

    // Whether within 2 px of a pixel something nearer ends in front of something farther: a jump
    // in depth of a fiftieth, more than any face of the scenes has from one pixel to the next.
    bool nearSilhouette(int px, int py) const
    {
        double nearest = 1e9;
        double farthest = 0.0;
        for (int y = std::max(0, py - 2); y <= std::min(HEIGHT - 1, py + 2); ++y)
            for (int x = std::max(0, px - 2); x <= std::min(WIDTH - 1, px + 2); ++x)
            {
                nearest = std::min(nearest, depthAt(x, y));
                farthest = std::max(farthest, depthAt(x, y));
            }
        return farthest > 1.02 * nearest;
    }

    bool nearSilhouette(const osg::Vec3d& window) const
    {
        return nearSilhouette(static_cast<int>(window.x()), static_cast<int>(window.y()));
    }
};

PlacePicture picture(OffscreenView& view, osg::Node& scene)
{
    return {copyOf(view.render(&scene)), view.camera().getViewMatrix(),
            view.camera().getProjectionMatrix()};
}

bool isVisible(const PlacePicture& direct, const osg::Vec3d& window)
{
    if (!(window.z() > 0.0 && window.x() >= 0.5 && window.x() <= WIDTH - 0.5 && window.y() >= 0.5 &&
          window.y() <= HEIGHT - 0.5))
        return false;
    // 0.2 %: more than a face's depth varies within a pixel, less than lies between a face and what
    // it hides.
    const double seen = direct.depthAt(static_cast<int>(window.x()), static_cast<int>(window.y()));
    return std::abs(window.z() - seen) <= 0.002 * seen;
}

} // namespace

MirrorComparison compareWithMirror(osg::Group& scene, WaterSurface& water,
                                   const osg::Plane& waterPlane, const MirrorView& view,
                                   const std::string& name)
{
    OffscreenView offscreen(WIDTH, HEIGHT, OffscreenView::Format::RGBA32F);
    offscreen.camera().setClearColor(osg::Vec4(0, 0, 0, 0));
    offscreen.look(view.eye, view.centre, view.fovyDegrees);
    offscreen.camera().setViewMatrix(
        offscreen.camera().getViewMatrix() *
        osg::Matrixd::rotate(osg::DegreesToRadians(view.rollDegrees), osg::Vec3d(0, 0, 1)));
    if (view.orthographicHeight > 0.0)
    {
        const double halfHeight = 0.5 * view.orthographicHeight;
        const double halfWidth = halfHeight * WIDTH / HEIGHT;
        offscreen.camera().setProjectionMatrixAsOrtho(-halfWidth, halfWidth, -halfHeight,
                                                      halfHeight, 0.1, 1000.0);
    }

    const osg::Vec2d shift = view.offAxis * 2.0;
    offscreen.camera().setProjectionMatrix(offscreen.camera().getProjectionMatrix() *
                                           osg::Matrixd::translate(shift.x(), shift.y(), 0.0));

    positionCodes::paint(scene);
    const PlacePicture direct = picture(offscreen, scene);

    osg::ref_ptr<osg::Group> withWater = new osg::Group;
    withWater->addChild(&scene);
    withWater->addChild(&water);
    water.setDebugView(WaterSurface::DebugView::REASON);
    const osg::ref_ptr<osg::Image> reasons = copyOf(offscreen.render(withWater));
    water.setDebugView(WaterSurface::DebugView::REFLECTION);
    const osg::ref_ptr<osg::Image> traced = copyOf(offscreen.render(withWater));

    const osg::Matrixd viewMatrix = offscreen.camera().getViewMatrix();
    positionCodes::paint(scene, waterPlane);
    offscreen.camera().setViewMatrix(mirrorMatrix(waterPlane) * viewMatrix);
    const PlacePicture mirrored = picture(offscreen, scene);

    keep(*reasons, name + "-reasons");

    MirrorComparison result;
    std::vector<double> errors;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
        {
            // Debug colours lie in (0, 1]; the background is black.
            const osg::Vec4 reason = pixel(*reasons, x, y);
            if (positionCodes::isPlace(reason) || reason.r() + reason.g() + reason.b() == 0.0f)
                continue;
            ++result.waterPixels;

            const osg::Vec4 tracedColour = pixel(*traced, x, y);
            const bool hit = (reason - HIT).length() < 1e-6;
            const osg::Vec4 trueColour = pixel(*mirrored.image, x, y);
            bool same = hit == positionCodes::isPlace(trueColour);
            if (hit && same)
            {
                const osg::Vec3d apart = mirrored.window(positionCodes::place(tracedColour)) -
                                         mirrored.window(positionCodes::place(trueColour));
                same = std::hypot(apart.x(), apart.y()) <= 1.5;
            }
            result.right += same;
            result.wrongInside += !same && !mirrored.nearSilhouette(x, y);
            if (!positionCodes::isPlace(trueColour))
            {
                ++result.sky;
                if (!hit) continue;
                ++result.skyHit;
                const osg::Vec3d window = direct.window(positionCodes::place(tracedColour));
                result.skyHitInside +=
                    !mirrored.nearSilhouette(x, y) && !direct.nearSilhouette(window);
                continue;
            }

            const osg::Vec3d trueWindow = direct.window(positionCodes::place(trueColour));
            if (!isVisible(direct, trueWindow)) continue;
            ++result.visible;
            bool right = false;
            bool atSilhouette = mirrored.nearSilhouette(x, y) || direct.nearSilhouette(trueWindow);
            if (hit)
            {
                const osg::Vec3d window = direct.window(positionCodes::place(tracedColour));
                errors.push_back(
                    std::hypot(window.x() - trueWindow.x(), window.y() - trueWindow.y()));
                right = errors.back() <= 1.5;
                atSilhouette = atSilhouette || direct.nearSilhouette(window);
            }
            result.visibleRight += right;
            result.visibleWrongInside += !right && !atSilhouette;
        }
    if (!errors.empty())
    {
        std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
        result.medianError = errors[errors.size() / 2];
    }
    return result;
}
