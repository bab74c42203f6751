#include "TracePass.h"

#include "../capture/FrameCopy.h"
#include "Bindings.h"

#include <algorithm>
#include <climits>
#include <cmath>

using namespace osgWaterReflect;

TracePass::TracePass() :
    _found(new osg::Texture2D),
    _foundFromWindow(new osg::Uniform(bindings::FOUND_FROM_WINDOW, osg::Vec4())),
    _stateSet(new osg::StateSet), _camera(new osg::Camera), _stateGraph(new osgUtil::StateGraph),
    _stage(new osgUtil::RenderStage)
{
    _found->setInternalFormat(GL_RGBA32F_ARB);
    _found->setSourceFormat(GL_RGBA);
    _found->setSourceType(GL_FLOAT);
    _found->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    _found->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    _found->setResizeNonPowerOfTwoHint(false);

    _camera->setName(CAMERA_NAME);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _found);
    _camera->attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT24);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    // Without it in the state, OSG falls back to the size that its viewports are made with.
    _stateSet->setAttribute(_stage->getViewport());
    _stage->setColorMask(new osg::ColorMask);
    _stage->setClearColor(osg::Vec4()); // no water
    _stage->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void TracePass::draw(osgUtil::CullVisitor& view, double scale, osg::StateSet& sheetState,
                     osg::StateSet& traceState, osg::Drawable& mesh,
                     const osg::Matrixd& eyeFromMesh)
{
    arrange(view);
    if (scale > _scale) resize(*view.getCurrentRenderStage()->getViewport(), scale);

    // The view's own near and far planes are fitted when its cull ends; these hold all water so
    // far.
    _projection->set(*view.getProjectionMatrix());
    if (view.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR)
    {
        double zNear = view.getCalculatedNearPlane();
        double zFar = view.getCalculatedFarPlane();
        view.clampProjectionMatrix(*_projection, zNear, zFar);
    }

    _program = traceState.getAttribute(osg::StateAttribute::PROGRAM);
    bindings::set(sheetState, bindings::SHEET, static_cast<float>(++_sheets));
    osgUtil::StateGraph* const leaves = _stateGraph->find_or_insert(_stateSet)
                                            ->find_or_insert(&sheetState)
                                            ->find_or_insert(&traceState);
    leaves->addLeaf(new osgUtil::RenderLeaf(&mesh, _projection, new osg::RefMatrix(eyeFromMesh)));
    _stage->addStateGraph(leaves);
}

// Each sheet moves the image to the end of what is rendered for the captures, for one of them may
// have been arranged just now.
void TracePass::arrange(osgUtil::CullVisitor& view)
{
    osgUtil::RenderStage& stage = *view.getCurrentRenderStage();
    osgUtil::RenderStage* const copy = FrameCopy::stageIn(stage);
    const auto takeFrom = [this](osgUtil::RenderStage::RenderStageList& stages)
    {
        const auto arranged =
            std::find_if(stages.begin(), stages.end(),
                         [this](const auto& other) { return other.second == _stage; });
        if (arranged != stages.end()) stages.erase(arranged);
    };
    takeFrom(stage.getPreRenderList());
    if (copy) takeFrom(copy->getPostRenderList());
    // In the order of captures, and of their pyramids.
    if (copy)
        copy->addPostRenderStage(_stage, INT_MAX);
    else
        stage.addPreRenderStage(_stage, INT_MAX);
}

void TracePass::begin()
{
    _scale = 0.0;
    _sheets = 0;
    _projection = new osg::RefMatrix;

    // A stage drops what it draws with each frame; the graph would keep the state of sheets that
    // are gone.
    _stage->reset();
    _stateGraph->reset();
    _stage->setInitialViewMatrix(new osg::RefMatrix);
}

void TracePass::resize(const osg::Viewport& view, double scale)
{
    _scale = scale;
    const double width = std::max(1.0, std::round(scale * view.width()));
    const double height = std::max(1.0, std::round(scale * view.height()));
    _stage->getViewport()->setViewport(0, 0, width, height);
    _camera->resizeAttachments(static_cast<int>(width), static_cast<int>(height));

    const double perX = width / view.width();
    const double perY = height / view.height();
    _foundFromWindow->set(osg::Vec4(perX, perY, -perX * view.x(), -perY * view.y()));
}

void TracePass::releaseGLObjects(osg::State* state) const
{
    if (_program) _program->releaseGLObjects(state);
    _found->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void TracePass::resizeGLObjectBuffers(unsigned int maxSize)
{
    _found->resizeGLObjectBuffers(maxSize);
    _stage->resizeGLObjectBuffers(maxSize);
}
