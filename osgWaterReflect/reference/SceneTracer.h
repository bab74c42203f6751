#ifndef OSGWATERREFLECT_REFERENCE_SCENETRACER_H
#define OSGWATERREFLECT_REFERENCE_SCENETRACER_H

#include <osg/Node>
#include <osg/Vec3d>
#include <osg/Vec4>

#include <memory>
#include <optional>

namespace osgWaterReflect::reference
{

/// Where a ray meets a scene.
struct SceneHit
{
    double t = 0.0;          ///< [world units] along the ray
    osg::Vec3d point;        ///< world space
    osg::Vec3d normal;       ///< of the triangle, on the side from which it runs counter clockwise
    osg::Vec4 colour;        ///< as drawn without light
    bool writesDepth = true; ///< so that screen space can hit it
};

/// Exact rays against the triangles of any scene: the truth against which everything that screen
/// space loses is measured. Nothing is shared with the shaders.
///
/// What belongs to the scene: the geometries of what a cull from nearby would choose (nodes without
/// a mask are left out, of a Switch what is on, of an LOD what a distance of 0 shows), from both
/// sides, culled faces too. No water, and nothing that is placed by the eye: billboards,
/// AutoTransforms, absolute transforms, and cameras but nested ones. Nor text, points and lines.
///
/// Colours are those drawn without light: the vertices' (overall, per primitive set or per vertex,
/// interpolated), times the 2D texture of unit 0, in its finest level, nearest or bilinear as it is
/// filtered when magnified. Programs, materials, blending, alpha tests, texture matrices and flat
/// shading are not followed: a texel that an alpha test would drop is hit.
///
/// The triangles are found by Embree, in single precision about the scene's centre, so that rays
/// never slip between two of them; the place on the triangle is found in double precision. A ray
/// that passes an outer edge closer than 1e-6 of the scene's radius, and which of two surfaces that
/// lie so close together comes first, may be told either way.
///
/// Everything but the textures' images is copied: later changes of the scene are not seen.
/// Rays may be traced by many threads at once.
class SceneTracer
{
public:
    enum class Kept
    {
        DEPTH_WRITERS = 1, ///< what can be hit in screen space
        ALL                ///< leaves, particles and sky domes, too
    };

    /// A scene without triangles, or without a device of Embree (with a message), is never hit.
    explicit SceneTracer(osg::Node& scene, Kept kept = Kept::DEPTH_WRITERS);
    ~SceneTracer();
    SceneTracer(const SceneTracer&) = delete;
    SceneTracer& operator=(const SceneTracer&) = delete;

    /// The nearest hit of a ray; none for values that are not finite, and for no direction.
    ///   dirWorld  of any length but 0
    ///   nearest   [world units] >= 0; hits before it are passed
    std::optional<SceneHit> trace(const osg::Vec3d& originWorld, const osg::Vec3d& dirWorld,
                                  double nearest = 0.0) const;

    /// Whether anything lies between two places.
    ///   clearance  [world units] >= 0; what is no farther from either end does not count
    bool occluded(const osg::Vec3d& fromWorld, const osg::Vec3d& toWorld,
                  double clearance = 0.0) const;

    std::size_t triangleCount() const;

private:
    struct Scene;
    std::unique_ptr<Scene> _scene;
};

} // namespace osgWaterReflect::reference

#endif
