#include "SheetPass.h"

#include "../Transforms.h"
#include "../surface/EyeHeight.h"
#include "Bindings.h"

#include <osg/Depth>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

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

// Waves need no mesh finer than this part of the shortest.
const double EDGES_PER_WAVE = 8.0;

// From surface space about the mesh's anchor.
glm::dmat4 eyeFromAnchor(const SheetView& view, const glm::dvec2& anchor)
{
    return glm::translate(view.eyeFromSurface, glm::dvec3(anchor, 0.0));
}

} // namespace

SheetPass::SheetPass() : _stateSet(new osg::StateSet)
{
    _stateSet->setRenderBinDetails(WATER_BIN, "RenderBin", osg::StateSet::USE_RENDERBIN_DETAILS);
    _stateSet->setNestRenderBins(false);
    _stateSet->setMode(GL_BLEND, OFF);
    _stateSet->setMode(GL_CULL_FACE, OFF);
    _stateSet->setMode(GL_DEPTH_TEST, ON);
    _stateSet->setAttribute(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, true), ON);
    bindings::set(*_stateSet, bindings::SKY, static_cast<int>(bindings::UNIT_SKY));
}

void SheetPass::setSearched(const Searched& searched, const std::string& name, unsigned int unit)
{
    const Capture& capture = searched.capture;
    const auto setImage = [&](const char* member, osg::Texture2D* image)
    {
        _stateSet->setTextureAttribute(unit, image, ON);
        bindings::set(*_stateSet, name + member, static_cast<int>(unit));
        ++unit;
    };
    setImage(bindings::COLOUR, capture.colour());
    setImage(bindings::WINDOW_Z, capture.windowZ());
    if (searched.pyramid)
        setImage(bindings::CELLS, searched.pyramid->cells());
    else
        _stateSet->removeTextureAttribute(unit, osg::StateAttribute::TEXTURE);

    const Capture::DepthScale depthScale = capture.depthScale();
    bindings::set(*_stateSet, name + bindings::SIZE, osg::Vec2(capture.size().x, capture.size().y));
    bindings::set(*_stateSet, name + bindings::IMAGE_FROM_EYE,
                  toOsgFloat(imageFromClip() * capture.clipFromEye()));
    bindings::set(*_stateSet, name + bindings::DEPTH_SCALE,
                  osg::Vec2(depthScale.perspective, depthScale.orthographic));
    bindings::set(*_stateSet, name + bindings::PIXEL_EXTENT,
                  static_cast<float>(capture.pixelExtent()));
    bindings::set(*_stateSet, name + bindings::FIRST_COLUMN, capture.isMirrored() ? 0.0f : 1.0f);
}

void SheetPass::setWater(const WaterSurface& water, const ReflectionSettings& settings,
                         Images images)
{
    _stateSet->setAttributeAndModes(waterProgram(water.getWaves()), ON);

    osg::TextureCubeMap* sky = const_cast<osg::TextureCubeMap*>(water.getSky());
    setVariant(*_stateSet, settings.search, images, sky ? SkySource::CUBE_MAP : SkySource::CAPTURED,
               water.getDebugView(), settings.traceScale < 1.0 ? Trace::SAMPLED : Trace::HERE);
    if (sky)
        _stateSet->setTextureAttribute(bindings::UNIT_SKY, sky, ON);
    else
        _stateSet->removeTextureAttribute(bindings::UNIT_SKY, osg::StateAttribute::TEXTURE);

    bindings::set(*_stateSet, bindings::THICKNESS,
                  static_cast<float>(std::min(settings.thickness, ENDLESS)));
    bindings::set(*_stateSet, bindings::STRIDE, static_cast<float>(settings.stride));
    bindings::set(*_stateSet, bindings::REFRACTIVE_INDEX,
                  static_cast<float>(water.getOptics().refractiveIndex));
    bindings::set(*_stateSet, bindings::WATER_COLOUR, water.getOptics().waterColour);
}

SheetPass::Mesh SheetPass::prepareMesh(const WaterSurface& water, const StillWater& sheet,
                                       const SheetView& view, double time)
{
    const WaveModel* waves = water.getWaves();
    if (!waves) return {sheet.calmMesh(), sheet.calmAnchor()};

    if (!_waveMesh) _waveMesh = new WaveMesh;
    _waveMesh->update(sheet, view, water.getDetail());
    const glm::dvec2& anchor = _waveMesh->anchor();
    waves->apply(*_stateSet, osg::Vec2d(anchor.x, anchor.y), time);
    return {_waveMesh->geometry(), anchor};
}

void SheetPass::setView(const SheetView& view, const glm::dmat4& eyeFromWorld,
                        const glm::dvec2& anchor, const WaveModel* waves, double time)
{
    const glm::dvec4 eyePointEye = eyePointOf(view.clipFromEye);
    const double height = heightOfEye(view.eyeFromSurface, view.clipFromEye, waves, time);

    bindings::set(*_stateSet, bindings::EYE_POINT_EYE,
                  osg::Vec4(eyePointEye.x, eyePointEye.y, eyePointEye.z, eyePointEye.w));
    bindings::set(*_stateSet, bindings::WORLD_FROM_EYE,
                  toOsgFloat(glm::dmat3(glm::inverse(eyeFromWorld))));
    bindings::set(*_stateSet, bindings::NORMAL_EYE_FROM_SURFACE,
                  toOsgFloat(normalMatrix(view.eyeFromSurface)));
    bindings::set(*_stateSet, bindings::SURFACE_FROM_EYE,
                  toOsgFloat(glm::inverse(eyeFromAnchor(view, anchor))));
    bindings::set(*_stateSet, bindings::SIDE, height < 0.0 ? -1.0f : 1.0f);
}

void SheetPass::setTraced(const TracePass* trace)
{
    if (trace)
    {
        _stateSet->setTextureAttribute(bindings::UNIT_FOUND, trace->found(), ON);
        bindings::set(*_stateSet, bindings::FOUND, static_cast<int>(bindings::UNIT_FOUND));
        _stateSet->addUniform(trace->foundFromWindow(), ON);
        return;
    }
    _stateSet->removeTextureAttribute(bindings::UNIT_FOUND, osg::StateAttribute::TEXTURE);
    for (const char* name : {bindings::FOUND, bindings::FOUND_FROM_WINDOW, bindings::SHEET})
        _stateSet->removeUniform(name);
}

void SheetPass::draw(osgUtil::CullVisitor& view, const std::vector<Searched>& searched,
                     TracePass& trace, const WaterSurface& water, const StillWater& sheet,
                     const ReflectionSettings& settings)
{
    const WaveModel* waves = water.getWaves();
    const double amplitude = waves ? waves->getAmplitude() : 0.0;
    const double time = view.getFrameStamp() ? view.getFrameStamp()->getSimulationTime() : 0.0;

    SheetView sheetView;
    sheetView.eyeFromSurface = fromOsg(*view.getModelViewMatrix()) * sheet.localFromSurface();
    sheetView.clipFromEye = fromOsg(*view.getProjectionMatrix());
    sheetView.viewportWidth = view.getViewport()->width();
    sheetView.viewportHeight = view.getViewport()->height();
    sheetView.amplitude = amplitude;
    if (waves)
    {
        sheetView.shortestEdge = waves->getShortestLength() / EDGES_PER_WAVE;
        sheetView.chordErrors = ChordErrors(*waves, sheetView.shortestEdge);
    }

    const Mesh mesh = prepareMesh(water, sheet, sheetView, time);
    const Images images = searched.size() == 2 ? Images::TWO : Images::ONE;
    setSearched(searched[0], bindings::EYE_CAPTURE, bindings::UNIT_EYE_CAPTURE);
    if (images == Images::TWO)
        setSearched(searched[1], bindings::MIRROR_CAPTURE, bindings::UNIT_MIRROR_CAPTURE);
    else
        for (unsigned int unit = bindings::UNIT_MIRROR_CAPTURE; unit < bindings::UNIT_SKY; ++unit)
            _stateSet->removeTextureAttribute(unit, osg::StateAttribute::TEXTURE);
    const osg::Vec4& clear = searched[0].capture.clearColour();
    bindings::set(*_stateSet, bindings::CLEAR_COLOUR, osg::Vec3(clear.r(), clear.g(), clear.b()));
    setWater(water, settings, images);
    setView(sheetView, fromOsg(*view.getCurrentRenderStage()->getInitialViewMatrix()), mesh.anchor,
            waves, time);

    const osg::BoundingBox bound = sheet.localBound(amplitude);
    view.updateCalculatedNearFar(*view.getModelViewMatrix(), bound);
    const osg::Matrixd eyeFromMesh = toOsg(eyeFromAnchor(sheetView, mesh.anchor));
    const double traceScale = settings.traceScale;
    const bool sampled = traceScale < 1.0;
    setTraced(sampled ? &trace : nullptr);
    if (sampled)
    {
        if (!_traceStateSet) _traceStateSet = new osg::StateSet;
        _traceStateSet->setAttributeAndModes(traceProgram(waves), ON);
        const bool counting = water.getDebugView() == WaterSurface::DebugView::HIT;
        setVariant(*_traceStateSet, settings.search, images, SkySource::CAPTURED,
                   counting ? WaterSurface::DebugView::HIT : WaterSurface::DebugView::NONE,
                   Trace::HERE);
        trace.draw(view, traceScale, *_stateSet, *_traceStateSet, *mesh.geometry, eyeFromMesh);
    }
    view.pushStateSet(_stateSet.get());
    view.addDrawableAndDepth(mesh.geometry, new osg::RefMatrix(eyeFromMesh),
                             view.getDistanceFromEyePoint(bound.center(), true));
    view.popStateSet();
}

void SheetPass::releaseGLObjects(osg::State* state) const
{
    _stateSet->releaseGLObjects(state);
    if (_traceStateSet) _traceStateSet->releaseGLObjects(state);
    if (_waveMesh) _waveMesh->geometry()->releaseGLObjects(state);
}

void SheetPass::resizeGLObjectBuffers(unsigned int maxSize)
{
    _stateSet->resizeGLObjectBuffers(maxSize);
    if (_traceStateSet) _traceStateSet->resizeGLObjectBuffers(maxSize);
    if (_waveMesh) _waveMesh->geometry()->resizeGLObjectBuffers(maxSize);
}
