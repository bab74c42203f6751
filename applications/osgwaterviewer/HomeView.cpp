#include "HomeView.h"

#include <osg/Math>

#include <algorithm>
#include <cmath>

using namespace osgwaterviewer;

namespace
{

// The eye looks down by this: steep enough to see the water between what stands in it, low enough
// for it to reflect half the light [Fresnel at 84 degrees].
const double ELEVATION_DEGREES = 6.0;

struct Perspective
{
    double fovyDegrees, aspectRatio, zNear, zFar;

    explicit Perspective(const osg::Camera& camera)
    {
        camera.getProjectionMatrixAsPerspective(fovyDegrees, aspectRatio, zNear, zFar);
    }
};

} // namespace

osg::Vec3d HomeView::up() const
{
    const osg::Vec3d look = centre - eye;
    const bool alongZ = std::hypot(look.x(), look.y()) < 1e-6 * look.length();
    return alongZ ? osg::Vec3d(0.0, 1.0, 0.0) : osg::Vec3d(0.0, 0.0, 1.0);
}

HomeView HomeView::over(osg::BoundingBoxd scene, const std::optional<double>& waterLevel,
                        double fovyDegrees)
{
    if (!scene.valid()) scene.set(-1.0, -1.0, -1.0, 1.0, 1.0, 1.0);
    if (waterLevel)
    {
        const double mirroredTop = 2.0 * *waterLevel - scene.zMax();
        scene.expandBy(scene.center().x(), scene.center().y(), mirroredTop);
    }
    const double radius = std::max(scene.radius(), 1e-6); // a single point has none
    const double distance = radius / std::sin(0.5 * osg::DegreesToRadians(fovyDegrees));
    const double elevation = osg::DegreesToRadians(ELEVATION_DEGREES);

    HomeView view;
    view.centre = scene.center();
    view.eye = view.centre + osg::Vec3d(0.0, -std::cos(elevation), std::sin(elevation)) * distance;
    return view;
}

double osgwaterviewer::fovyDegreesOf(const osg::Camera& camera)
{
    return Perspective(camera).fovyDegrees;
}

void osgwaterviewer::setFovyDegrees(osg::Camera& camera, double fovyDegrees)
{
    const Perspective old(camera);
    camera.setProjectionMatrixAsPerspective(fovyDegrees, old.aspectRatio, old.zNear, old.zFar);
}
