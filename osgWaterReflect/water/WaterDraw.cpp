#include "WaterDraw.h"

#include "../Transforms.h"
#include "../shaders/Bindings.h"

#include <osg/Depth>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

// Between what is opaque (0) and what is transparent (10).
const int WATER_BIN = 9;

const unsigned int ON = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
const unsigned int OFF = osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED;

// [world units] Of thicknesses: what is more is as good as endless, and single precision has room
// for its products with depths.
const double ENDLESS = 1e15;

} // namespace

WaterDraw::WaterDraw() :
    _stateSet(new osg::StateSet), _eyeCapture(bindings::EYE_CAPTURE, bindings::UNIT_EYE_CAPTURE),
    _mirrorCapture(bindings::MIRROR_CAPTURE, bindings::UNIT_MIRROR_CAPTURE)
{
    _stateSet->setRenderBinDetails(WATER_BIN, "RenderBin", osg::StateSet::USE_RENDERBIN_DETAILS);
    _stateSet->setNestRenderBins(false);
    _stateSet->setMode(GL_BLEND, OFF);
    _stateSet->setMode(GL_CULL_FACE, OFF);
    _stateSet->setMode(GL_DEPTH_TEST, ON);
    _stateSet->setAttribute(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, true), ON);
}

void WaterDraw::enrol(osgUtil::CullVisitor& view, const VisibleSheet& visible)
{
    _mesh = visible.sheet->calmMesh();
    if (visible.waves)
    {
        if (!_waveMesh) _waveMesh = new WaveMesh;
        _mesh = _waveMesh->geometry();
    }
    // An object of its own: osg::State skips a matrix that it has loaded last.
    _eyeFromMesh = new osg::RefMatrix;
    const osg::BoundingBox bound = visible.sheet->localBound(visible.bounds->amplitude);
    view.updateCalculatedNearFar(*view.getModelViewMatrix(), bound);
    view.pushStateSet(_stateSet.get());
    view.pushStateSet(_effects.stateSet());
    view.addDrawableAndDepth(_mesh.get(), _eyeFromMesh.get(),
                             view.getDistanceFromEyePoint(bound.center(), true));
    view.popStateSet();
    view.popStateSet();
}

void WaterDraw::prepare(const CulledView& view, const VisibleSheet& visible,
                        const WaterSettings& settings, const std::vector<const Effect*>& effects,
                        const SearchedCapture& first, const SearchedCapture& second,
                        const Capture* scene, LowResTrace& trace)
{
    const glm::dvec2 anchor = prepareMesh(view, visible);
    const glm::dmat4 eyeFromAnchor =
        glm::translate(visible.eyeFromSurface, glm::dvec3(anchor, 0.0));
    _eyeFromMesh->set(toOsg(eyeFromAnchor));

    _eyeCapture.bind(*_stateSet, *first.capture, first.cells, first.sky);
    if (second.capture)
        _mirrorCapture.bind(*_stateSet, *second.capture, second.cells, second.sky);
    else
        _mirrorCapture.unbind(*_stateSet);
    const Images images = second.capture ? Images::TWO : Images::ONE;
    const osg::Vec4& clear = first.capture->clearColour();
    bindings::set(*_stateSet, bindings::CLEAR_COLOUR, osg::Vec3(clear.r(), clear.g(), clear.b()));
    setWater(*visible.water, settings);
    setView(view, visible, eyeFromAnchor);
    _effects.update(effects, *visible.water, {fromOsg(view.eyeFromWorld), scene});
    _program.set(*_stateSet, keyOf(WaterPass::SHADE, *visible.water, settings, images, effects));
    setTraced(trace, visible, settings, images);
}

glm::dvec2 WaterDraw::prepareMesh(const CulledView& view, const VisibleSheet& visible)
{
    if (!visible.waves) return visible.sheet->calmAnchor();

    SheetView sheetView;
    sheetView.eyeFromSurface = visible.eyeFromSurface;
    sheetView.clipFromEye = view.clipFromEye;
    sheetView.viewportWidth = view.viewport->width();
    sheetView.viewportHeight = view.viewport->height();
    sheetView.waves = *visible.bounds;
    _waveMesh->update(*visible.sheet, sheetView, visible.water->getDetail());
    const glm::dvec2& anchor = _waveMesh->anchor();
    visible.waves->apply(*_stateSet, osg::Vec2d(anchor.x, anchor.y));
    return anchor;
}

void WaterDraw::setWater(const WaterSurface& water, const WaterSettings& settings)
{
    bindings::set(*_stateSet, bindings::HIT_THICKNESS,
                  static_cast<float>(std::min(settings.thickness, ENDLESS)));
    bindings::set(*_stateSet, bindings::COLUMN_STRIDE, static_cast<float>(settings.stride));
    bindings::set(*_stateSet, bindings::WATER_REFRACTIVE_INDEX,
                  static_cast<float>(water.getOptics().refractiveIndex));
}

void WaterDraw::setView(const CulledView& view, const VisibleSheet& visible,
                        const glm::dmat4& eyeFromAnchor)
{
    const glm::dvec4 eyePointEye = eyePointOf(view.clipFromEye);
    bindings::set(*_stateSet, bindings::EYE_POINT_EYE,
                  osg::Vec4(eyePointEye.x, eyePointEye.y, eyePointEye.z, eyePointEye.w));
    bindings::set(*_stateSet, bindings::NORMAL_EYE_FROM_SURFACE,
                  toOsgFloat(normalMatrix(visible.eyeFromSurface)));
    bindings::set(*_stateSet, bindings::SURFACE_FROM_EYE, toOsgFloat(glm::inverse(eyeFromAnchor)));
    bindings::set(*_stateSet, bindings::EYE_SIDE, visible.eyeAbove ? 1.0f : -1.0f);
}

void WaterDraw::setTraced(LowResTrace& trace, const VisibleSheet& visible,
                          const WaterSettings& settings, Images images)
{
    if (settings.traceScale >= 1.0)
    {
        if (!_stateSet->getUniform(bindings::TRACED_RAYS)) return;
        _stateSet->removeTextureAttribute(bindings::UNIT_TRACED_RAYS, osg::StateAttribute::TEXTURE);
        _stateSet->removeUniform(bindings::TRACED_RAYS);
        _stateSet->removeUniform(bindings::TRACED_FROM_WINDOW);
        _stateSet->removeUniform(bindings::SHEET_NUMBER);
        return;
    }
    _stateSet->setTextureAttribute(bindings::UNIT_TRACED_RAYS, trace.rays(), ON);
    bindings::set(*_stateSet, bindings::TRACED_RAYS, static_cast<int>(bindings::UNIT_TRACED_RAYS));
    _stateSet->addUniform(trace.tracedFromWindow(), ON);

    if (!_traceStateSet) _traceStateSet = new osg::StateSet;
    _traceProgram.set(*_traceStateSet,
                      keyOf(WaterPass::TRACE, *visible.water, settings, images, {}));
    trace.addSheet(*_stateSet, *_traceStateSet, *_mesh, *_eyeFromMesh);
}

const std::string& WaterDraw::programName() const
{
    static const std::string none;
    const osg::StateAttribute* const program =
        _stateSet->getAttribute(osg::StateAttribute::PROGRAM);
    return program ? program->getName() : none;
}

void WaterDraw::releaseGLObjects(osg::State* state) const
{
    _stateSet->releaseGLObjects(state);
    _effects.stateSet()->releaseGLObjects(state);
    if (_traceStateSet) _traceStateSet->releaseGLObjects(state);
    if (_waveMesh) _waveMesh->geometry()->releaseGLObjects(state);
}

void WaterDraw::resizeGLObjectBuffers(unsigned int maxSize)
{
    _stateSet->resizeGLObjectBuffers(maxSize);
    _effects.stateSet()->resizeGLObjectBuffers(maxSize);
    if (_traceStateSet) _traceStateSet->resizeGLObjectBuffers(maxSize);
    if (_waveMesh) _waveMesh->geometry()->resizeGLObjectBuffers(maxSize);
}
