#ifndef OSGWATERREFLECT_TESTS_SUPPORT_MIRRORTRUTH_H
#define OSGWATERREFLECT_TESTS_SUPPORT_MIRRORTRUTH_H

#include <osgWaterReflect/WaterSurface>

#include <osg/Group>
#include <osg/Plane>

/// One eye over one calm water, for comparing what is traced with what the mirrored eye sees.
struct MirrorView
{
    osg::Vec3d eye;
    osg::Vec3d centre;
    double fovyDegrees = 46.0;
    double rollDegrees = 0.0;
    double orthographicHeight = 0.0; ///< [world units] above 0: of an orthographic view
    osg::Vec2d offAxis{};            ///< [sizes of the image] by which its middle is moved
};

/// How the water's pixels of one picture compare with the same scene drawn from the mirrored eye.
struct MirrorComparison
{
    int waterPixels = 0;
    int right = 0;              ///< of them all: sky for sky, or within 1.5 px of the true place
                                ///< as the mirrored eye sees it
    int wrongInside = 0;        ///< of the others, those not within 2 px of its silhouettes
    int visible = 0;            ///< whose true reflection is seen in the captured image
    int visibleRight = 0;       ///< of these, traced within 1.5 px of the true place
    int visibleWrongInside = 0; ///< of the others, those not within 2 px of a silhouette
    double medianError = 0.0;   ///< [pixels] of those traced to some place
    int sky = 0;                ///< whose true reflection is sky
    int skyHit = 0;             ///< of these, traced to some place
    int skyHitInside = 0;       ///< of these, those not within 2 px of a silhouette
};

/// Renders a scene (in world coordinates, nothing else below it) with water from a view, and from
/// the eye mirrored in the plane, and compares pixel by pixel. The pictures are kept under a name.
MirrorComparison compareWithMirror(osg::Group& scene, osgWaterReflect::WaterSurface& water,
                                   const osg::Plane& waterPlane, const MirrorView& view,
                                   const std::string& name);

#endif
