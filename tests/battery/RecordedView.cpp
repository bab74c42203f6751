#include "RecordedView.h"

#include "../support/CapturedImages.h"
#include "../support/Catch.h"
#include "../support/OffscreenView.h"
#include "../support/Scenes.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/TrochoidalWaves>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace battery;
using namespace osgWaterReflect;

namespace
{

const int WIDTH = 320;
const int HEIGHT = 240;

// What is looked at, and how.
struct Look
{
    const char* name;
    osg::Vec3d eye;
    osg::Vec3d centre;
    osg::Vec3d up = osg::Vec3d(0, 0, 1);
    double fovyDegrees = 46.0; // 0: orthographic
    double steepness = 0.0;    // of the waves; 0: calm
};

const Look LOOKS[] = {
    {"level", {1, -14, 2}, {1, 0, 2}},
    {"level, waves", {1, -14, 2}, {1, 0, 2}, {0, 0, 1}, 46.0, 0.1},
    {"pitched", {1, -14, 3.5}, {0, 0, 0.5}},
    {"pitched, waves", {1, -14, 3.5}, {0, 0, 0.5}, {0, 0, 1}, 46.0, 0.1},
    {"pitched, steep waves", {1, -14, 3.5}, {0, 0, 0.5}, {0, 0, 1}, 46.0, 0.6},
    {"from above", {0.5, -2, 12}, {0, 0, 0}},
    {"straight down", {0, 0.5, 9}, {0, 0.5, 0}, {0, 1, 0}},
    {"grazing", {1, -14, 0.001}, {0, 0, 0.001}},
    {"grazing, waves", {1, -14, 0.3}, {0, 0, 0.2}, {0, 0, 1}, 46.0, 0.1},
    {"rolled", {1, -14, 3.5}, {0, 0, 0.5}, {0.5, 0, 0.9}, 46.0, 0.1},
    {"wide", {0.3, -6, 1.5}, {0, 0, 0.5}, {0, 0, 1}, 120.0},
    {"orthographic", {4, -14, 6}, {0, 0, 0}, {0, 0, 1}, 0.0},
    {"orthographic, waves", {4, -14, 6}, {0, 0, 0}, {0, 0, 1}, 0.0, 0.1},
    {"from under the water", {1, -9, -1.5}, {0, 0, 0.5}},
};

void aim(osg::Camera& camera, const Look& look)
{
    camera.setViewMatrixAsLookAt(look.eye, look.centre, look.up);
    const double aspect = static_cast<double>(WIDTH) / HEIGHT;
    if (look.fovyDegrees > 0.0)
        camera.setProjectionMatrixAsPerspective(look.fovyDegrees, aspect, 0.1, 1000.0);
    else
        camera.setProjectionMatrixAsOrtho(-5.0 * aspect, 5.0 * aspect, -5.0, 5.0, 0.1, 1000.0);
}

RayImage imageOf(const CapturedImage& captured, const WaterSurface& water)
{
    RayImage image;
    image.size = {captured.windowZ->s(), captured.windowZ->t()};
    const float* const windowZ = reinterpret_cast<const float*>(captured.windowZ->data());
    image.windowZ.assign(windowZ, windowZ + static_cast<std::size_t>(image.size.x) * image.size.y);
    image.clipFromEye = fromOsg(captured.clipFromEye);
    image.thickness = water.getReflection().thickness;
    return image;
}

// As reflected_ray.glsl has it.
glm::vec3 reflectedDir(const glm::vec3& toEye, const glm::vec3& normal, const glm::vec3& still)
{
    const glm::vec3 reflected = glm::reflect(-toEye, normal);
    return glm::normalize(reflected - 2.0f * std::min(glm::dot(reflected, still), 0.0f) * still);
}

glm::vec3 xyz(const osg::Vec4& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

std::vector<RecordedView> battery::recordViews()
{
    const osg::ref_ptr<WaterSurface> water = scenes::createLake();
    const osg::ref_ptr<osg::Group> scene = scenes::together({scenes::createHarbour(), water});
    std::vector<RecordedView> views;
    for (const Look& look : LOOKS)
    {
        OffscreenView view(WIDTH, HEIGHT, OffscreenView::Format::RGBA32F);
        aim(view.camera(), look);
        water->setWaves(look.steepness > 0.0 ? TrochoidalWaves::createBreeze(2.0, look.steepness)
                                             : nullptr);
        const osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
        water->setDebugView(WaterSurface::DebugView::POINT);
        const osg::ref_ptr<osg::Image> points = copyOf(view.render(scene, 3.0));
        water->setDebugView(WaterSurface::DebugView::NORMAL);
        const osg::Image& normals = view.render(scene, 3.0);

        RecordedView recorded;
        recorded.image = imageOf(captured->one(), *water);
        recorded.image.name = look.name;
        const glm::dmat4 eyeFromWorld = fromOsg(view.camera().getViewMatrix());
        const glm::vec3 still((look.eye.z() < 0.0 ? -1.0 : 1.0) * glm::dvec3(eyeFromWorld[2]));
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = 0; x < WIDTH; ++x)
            {
                const osg::Vec4 point = pixel(*points, x, y);
                if (point.w() != -1.0f) continue; // no water
                const glm::vec3 toEye = look.fovyDegrees > 0.0 ? glm::normalize(-xyz(point))
                                                               : glm::vec3(0.0f, 0.0f, 1.0f);
                recorded.rays.push_back(
                    {xyz(point), reflectedDir(toEye, xyz(pixel(normals, x, y)), still)});
            }
        INFO(look.name);
        REQUIRE(recorded.rays.size() > 1000);
        views.push_back(recorded);
    }
    return views;
}
