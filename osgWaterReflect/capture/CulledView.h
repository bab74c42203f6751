#ifndef OSGWATERREFLECT_CAPTURE_CULLEDVIEW_H
#define OSGWATERREFLECT_CAPTURE_CULLEDVIEW_H

#include <osg/CullSettings>
#include <osg/Viewport>
#include <osgUtil/CullVisitor>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

namespace osgWaterReflect
{

/// A view whose cull has come to water, as its visitor knows it there and has forgotten when that
/// cull is over: all that the scene can be culled with once more.
///
/// The scene is what is below a camera: the innermost on the way to the water that has an image of
/// its own, or matrices of its own (NESTED_RENDER).
struct CulledView
{
    osgUtil::CullVisitor* visitor = nullptr;
    osgUtil::RenderStage* stage = nullptr; ///< that the water is drawn in
    osg::Camera* stageCamera = nullptr;    ///< of that stage
    osg::Camera* camera = nullptr;         ///< below which is the scene
    osg::NodePath cameraPath; ///< from the view's root to that camera; empty where it is the view's
    std::vector<const osg::StateSet*> stateSets; ///< above the scene, outermost first
    osg::Node::NodeMask traversalMask = ~0u;
    osg::CullSettings cullSettings;
    osg::Vec3 referenceViewPoint;

    osg::ref_ptr<osg::Viewport> viewport;
    osg::Matrixd eyeFromWorld;    ///< for row vectors
    glm::dmat4 clipFromEye{1.0};  ///< near and far not yet fitted to what the view draws
    unsigned int frameNumber = 0; ///< the traversal's

    /// The view's own projection: when its cull is over, near and far have been fitted.
    osg::ref_ptr<const osg::RefMatrix> fittedProjection;

    /// Notes a view in the middle of its cull.
    void note(osgUtil::CullVisitor& view);

    /// Lets go of what would live longer than the frame.
    void forget();

    /// Whether the scene is below a camera that draws into the image of another.
    bool isNested() const { return camera != stageCamera; }

    /// [pixels] Of the viewport, rounded up.
    glm::ivec2 viewportSize() const;
};

/// The camera below which the scene of the water is that a view has come to; see CulledView.
osg::Camera& sceneCameraOf(osgUtil::CullVisitor& view);

} // namespace osgWaterReflect

#endif
