#include "LowResTrace.h"

#include "../shaders/Bindings.h"

#include <algorithm>
#include <climits>
#include <cmath>

using namespace osgWaterReflect;

LowResTrace::LowResTrace() :
    _rays(new osg::Texture2D),
    _tracedFromWindow(new osg::Uniform(bindings::TRACED_FROM_WINDOW.c_str(), osg::Vec4())),
    _stateSet(new osg::StateSet), _camera(new osg::Camera), _stateGraph(new osgUtil::StateGraph),
    _stage(new osgUtil::RenderStage)
{
    _rays->setInternalFormat(GL_RGBA32F_ARB);
    _rays->setSourceFormat(GL_RGBA);
    _rays->setSourceType(GL_FLOAT);
    _rays->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    _rays->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    _rays->setResizeNonPowerOfTwoHint(false);

    _camera->setName(CAMERA_NAME);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setImplicitBufferAttachmentMask(0, 0);
    _camera->attach(osg::Camera::COLOR_BUFFER0, _rays);
    _camera->attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT24);
    _stage->setCamera(_camera);
    _stage->setViewport(new osg::Viewport);
    // Without it in the state, OSG falls back to the size that its viewports are made with.
    _stateSet->setAttribute(_stage->getViewport());
    _stage->setColorMask(new osg::ColorMask);
    _stage->setClearColor(osg::Vec4()); // no water
    _stage->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void LowResTrace::begin(const CulledView& view, double scale)
{
    clear();
    resize(*view.stage->getViewport(), scale);
    _projection = new osg::RefMatrix(*view.fittedProjection);
    _stage->setInitialViewMatrix(new osg::RefMatrix);
}

// A stage drops what it draws with each frame; the graph would keep the state of sheets that are
// gone.
void LowResTrace::clear()
{
    if (!_projection) return;
    _projection = nullptr;
    _sheets = 0;
    _stage->reset();
    _stateGraph->reset();
}

void LowResTrace::addSheet(osg::StateSet& sheetState, osg::StateSet& traceState,
                           osg::Drawable& mesh, osg::RefMatrix& eyeFromMesh)
{
    _program = traceState.getAttribute(osg::StateAttribute::PROGRAM);
    bindings::set(sheetState, bindings::SHEET_NUMBER, static_cast<float>(++_sheets));
    osgUtil::StateGraph* const leaves = _stateGraph->find_or_insert(_stateSet)
                                            ->find_or_insert(&sheetState)
                                            ->find_or_insert(&traceState);
    leaves->addLeaf(new osgUtil::RenderLeaf(&mesh, _projection, &eyeFromMesh));
    _stage->addStateGraph(leaves);
}

void LowResTrace::draw(const CulledView& view, osgUtil::RenderStage* copy)
{
    _stage->sort();
    if (copy)
        copy->addPostRenderStage(_stage, INT_MAX);
    else
        view.stage->addPreRenderStage(_stage, INT_MAX);
}

void LowResTrace::resize(const osg::Viewport& view, double scale)
{
    const double width = std::max(1.0, std::round(scale * view.width()));
    const double height = std::max(1.0, std::round(scale * view.height()));
    _stage->getViewport()->setViewport(0, 0, width, height);
    _camera->resizeAttachments(static_cast<int>(width), static_cast<int>(height));

    const double perX = width / view.width();
    const double perY = height / view.height();
    _tracedFromWindow->set(osg::Vec4(perX, perY, -perX * view.x(), -perY * view.y()));
}

void LowResTrace::releaseGLObjects(osg::State* state) const
{
    if (_program) _program->releaseGLObjects(state);
    _rays->releaseGLObjects(state);
    _stage->releaseGLObjects(state);
}

void LowResTrace::resizeGLObjectBuffers(unsigned int maxSize)
{
    _rays->resizeGLObjectBuffers(maxSize);
    _stage->resizeGLObjectBuffers(maxSize);
}
