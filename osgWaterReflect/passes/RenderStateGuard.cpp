#include "RenderStateGuard.h"

#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osgUtil/StateGraph>

using namespace osgWaterReflect;

// The matrices are copied: osg::State skips one that it has loaded last, but every stage loads the
// identity behind its back.
RenderStateGuard::RenderStateGuard(osg::State& state, const osgUtil::RenderLeaf* last) :
    _state(state), _stateSets(state.getStateSetStack()),
    _lastStateSet(last ? last->_parent->getStateSet() : nullptr),
    _initialView(new osg::RefMatrix(state.getInitialViewMatrix())),
    _projection(new osg::RefMatrix(state.getProjectionMatrix())),
    _modelView(new osg::RefMatrix(state.getModelViewMatrix()))
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING_EXT, &_drawFramebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING_EXT, &_readFramebuffer);
    glGetIntegerv(GL_VIEWPORT, _viewport);
    glGetIntegerv(GL_SCISSOR_BOX, _scissor);
    glGetBooleanv(GL_COLOR_WRITEMASK, _colourMask);

    // Not popAllStateSets(): it forgets the program but not that it is applied.
    state.popStateSetStackToSize(0);
    state.apply();
}

RenderStateGuard::~RenderStateGuard()
{
    _state.popStateSetStackToSize(0);
    for (const osg::StateSet* stateSet : _stateSets)
        _state.pushStateSet(stateSet);
    _state.setInitialViewMatrix(_initialView);
    _state.applyProjectionMatrix(_projection);
    _state.applyModelViewMatrix(_modelView);
    _state.apply(_lastStateSet);

    const auto* gl = _state.get<osg::GLExtensions>();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, _drawFramebuffer);
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, _readFramebuffer);
    glViewport(_viewport[0], _viewport[1], _viewport[2], _viewport[3]);
    glScissor(_scissor[0], _scissor[1], _scissor[2], _scissor[3]);
    glColorMask(_colourMask[0], _colourMask[1], _colourMask[2], _colourMask[3]);
}
