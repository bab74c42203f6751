#ifndef OSGWATERVIEWER_HOMEVIEW_H
#define OSGWATERVIEWER_HOMEVIEW_H

#include <osg/BoundingBox>
#include <osg/Camera>
#include <osg/Vec3d>

#include <optional>

namespace osgwaterviewer
{

/// Where the eye is to begin with, and where the space key takes it back to.
struct HomeView
{
    osg::Vec3d eye;    ///< [world units]
    osg::Vec3d centre; ///< [world units] the point it looks at

    /// Up is z, or y where the eye looks along z.
    osg::Vec3d up() const;

    /// All of a scene is in the picture and, where there is water at a level, its mirror image too.
    static HomeView over(osg::BoundingBoxd scene, const std::optional<double>& waterLevel,
                         double fovyDegrees);
};

/// The vertical field of view of a camera.
double fovyDegreesOf(const osg::Camera& camera);
void setFovyDegrees(osg::Camera& camera, double fovyDegrees);

} // namespace osgwaterviewer

#endif
