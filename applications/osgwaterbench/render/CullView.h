#ifndef OSGWATERBENCH_CULLVIEW_H
#define OSGWATERBENCH_CULLVIEW_H

#include <osgUtil/SceneView>

#include <glm/vec2.hpp>

namespace osgwaterbench
{

/// A scene in a view of its own that is culled and never drawn: it needs no graphics context.
class CullView
{
public:
    /// size  [pixels] of the picture
    CullView(osg::Node& scene, const glm::ivec2& size);

    void setEye(const osg::Vec3d& eye, const osg::Vec3d& centre, double fovyDegrees);

    /// The next frame, at a time [s].
    void cull(double time);

    /// As the last cull filled it.
    const osgUtil::RenderStage& stage() const { return *_view->getRenderStage(); }

private:
    osg::ref_ptr<osg::FrameStamp> _frameStamp = new osg::FrameStamp;
    osg::ref_ptr<osgUtil::SceneView> _view = new osgUtil::SceneView;
};

} // namespace osgwaterbench

#endif
