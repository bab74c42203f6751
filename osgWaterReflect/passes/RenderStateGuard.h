#ifndef OSGWATERREFLECT_PASSES_RENDERSTATEGUARD_H
#define OSGWATERREFLECT_PASSES_RENDERSTATEGUARD_H

#include <osg/State>
#include <osgUtil/RenderLeaf>

namespace osgWaterReflect
{

/// A pause between two leaves of a render stage that is being drawn, in which other stages can be
/// drawn: they begin with osg::State's stack empty and its defaults applied. With its end, OpenGL
/// and osg::State are as they were.
///
/// Kept is what a RenderStage changes, with osg::State or behind its back: framebuffers, viewport,
/// scissor box, colour mask, matrices, and the stack of StateSets.
class RenderStateGuard
{
public:
    ///   last  the leaf that has been drawn last, whose state is applied now; null: none has
    RenderStateGuard(osg::State& state, const osgUtil::RenderLeaf* last);
    ~RenderStateGuard();
    RenderStateGuard(const RenderStateGuard&) = delete;
    RenderStateGuard& operator=(const RenderStateGuard&) = delete;

private:
    osg::State& _state;
    const osg::State::StateSetStack _stateSets;
    const osg::StateSet* const _lastStateSet; // applied on top of these
    const osg::ref_ptr<osg::RefMatrix> _initialView;
    const osg::ref_ptr<osg::RefMatrix> _projection;
    const osg::ref_ptr<osg::RefMatrix> _modelView;
    GLint _drawFramebuffer = 0;
    GLint _readFramebuffer = 0;
    GLint _viewport[4];
    GLint _scissor[4];
    GLboolean _colourMask[4];
};

} // namespace osgWaterReflect

#endif
