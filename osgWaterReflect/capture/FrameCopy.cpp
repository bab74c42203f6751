#include "FrameCopy.h"

#include "../Transforms.h"
#include "../passes/RenderStateGuard.h"
#include "../shaders/Bindings.h"
#include "../shaders/SharedProgram.h"

#include <osg/Depth>
#include <osg/GLExtensions>
#include <osgUtil/RenderBin>

using namespace osgWaterReflect;

namespace
{

// The last before the water's (water/WaterDraw.cpp).
const int BIN = 8;

const int UNIT_COLOUR = 0;
const int UNIT_WINDOW_Z = 1;

} // namespace

// Draws a bin as it would have been drawn without, and then the copy.
class FrameCopy::DrawCallback : public osgUtil::RenderBin::DrawCallback
{
public:
    DrawCallback(FrameCopy& copy, osgUtil::RenderBin::DrawCallback* bins) :
        _copy(&copy), _bins(bins)
    {
    }

    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& renderInfo,
                            osgUtil::RenderLeaf*& previous) override
    {
        if (_bins)
            _bins->drawImplementation(bin, renderInfo, previous);
        else
            bin->drawImplementation(renderInfo, previous);
        _copy->draw(renderInfo, previous);
    }

    FrameCopy& copy() const { return *_copy; }

private:
    const osg::ref_ptr<FrameCopy> _copy;
    const osg::ref_ptr<osgUtil::RenderBin::DrawCallback> _bins;
};

// Copies the frame as a part of its own drawing, so that its camera's callbacks come before and
// after all of the copy.
class FrameCopy::Stage : public ImageStage
{
public:
    explicit Stage(FrameCopy& copy) : _copy(copy) {}

    void drawInner(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*& previous,
                   bool& doCopyTexture) override
    {
        osg::State& state = *renderInfo.getState();
        state.get<osg::GLExtensions>()->glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT,
                                                          _copy._framebuffer);
        const bool copied = _copy._frame->copy(state, *_copy._viewport, _copy._colourFormat);
        setClearMask(copied ? 0 : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (!copied) getStateGraphList().clear();
        const glm::dvec2 farGap =
            farGapBetween(fromOsg(*_copy._frameProjection), fromOsg(*_copy._captureProjection));
        bindings::set(stateSet(), bindings::CAPTURE_FAR_GAP, osg::Vec2(farGap.x, farGap.y));
        ImageStage::drawInner(renderInfo, previous, doCopyTexture);
    }

private:
    FrameCopy& _copy; // that has this
};

FrameCopy::FrameCopy() : _frame(new FrameImages), _stage(new Stage(*this))
{
    osg::StateSet& stateSet = _stage->stateSet();
    stateSet.setTextureAttribute(UNIT_COLOUR, _frame->colour());
    stateSet.setTextureAttribute(UNIT_WINDOW_Z, _frame->windowZ());
    bindings::set(stateSet, bindings::FRAME_COLOUR, UNIT_COLOUR);
    bindings::set(stateSet, bindings::FRAME_WINDOW_Z, UNIT_WINDOW_Z);
    stateSet.setMode(GL_DEPTH_TEST, osg::StateAttribute::ON); // without, no depth is written
    stateSet.setAttribute(new osg::Depth(osg::Depth::ALWAYS));
}

osg::ref_ptr<osg::Program> FrameCopy::program()
{
    return sharedProgram("fullscreen.vert", "frame_copy.frag");
}

void FrameCopy::arrange(const CulledView& view, osg::Camera& target, const osg::Viewport& place,
                        const osg::RefMatrix& captureProjection)
{
    osgUtil::RenderStage& viewStage = *view.stage;
    _viewport = viewStage.getViewport();
    _frameProjection = view.fittedProjection;
    _captureProjection = &captureProjection;
    _colourFormat =
        target.getBufferAttachmentMap()[osg::Camera::COLOR_BUFFER0]._texture->getInternalFormat();

    _stage->setCamera(&target);
    _stage->setClearColor(viewStage.getClearColor());
    if (!_stage->stateSet().getAttribute(osg::StateAttribute::PROGRAM))
        _stage->stateSet().setAttributeAndModes(program());
    _stage->prepare(place.x(), place.y(), place.width(), place.height());
    const double pixelX = _viewport->width() / place.width();
    const double pixelY = _viewport->height() / place.height();
    bindings::set(_stage->stateSet(), bindings::FRAME_FROM_CAPTURE,
                  osg::Vec4(-pixelX * place.x(), -pixelY * place.y(), pixelX, pixelY));

    osgUtil::RenderBin* bin = viewStage.find_or_insert(BIN, "RenderBin");
    bin->setDrawCallback(new DrawCallback(*this, bin->getDrawCallback()));
}

osgUtil::RenderStage* FrameCopy::stageIn(osgUtil::RenderStage& viewStage)
{
    const auto& bins = viewStage.getRenderBinList();
    const auto bin = bins.find(BIN);
    if (bin == bins.end()) return nullptr;
    const auto* const callback = dynamic_cast<DrawCallback*>(bin->second->getDrawCallback());
    return callback ? &callback->copy().stage() : nullptr;
}

void FrameCopy::draw(osg::RenderInfo& renderInfo, const osgUtil::RenderLeaf* last)
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING_EXT, &_framebuffer);
    const RenderStateGuard guard(*renderInfo.getState(), last);
    osgUtil::RenderLeaf* none = nullptr;
    _stage->draw(renderInfo, none);
}

void FrameCopy::releaseGLObjects(osg::State* state) const
{
    _frame->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void FrameCopy::resizeGLObjectBuffers(unsigned int maxSize)
{
    _frame->resizeGLObjectBuffers(maxSize);
    _stage->resizeGLObjectBuffers(maxSize);
}
