#include "SheetPass.h"

#include "../Transforms.h"
#include "Bindings.h"
#include "WaterProgram.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace osgWaterReflect;

namespace
{

// Between what is opaque (0) and what is transparent (10).
const int WATER_BIN = 9;

const unsigned int ON = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
const unsigned int OFF = osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED;

// Waves need no mesh finer than this part of the shortest.
const double EDGES_PER_WAVE = 8.0;

} // namespace

SheetPass::SheetPass() : _stateSet(new osg::StateSet)
{
    _stateSet->setRenderBinDetails(WATER_BIN, "RenderBin",
                                   osg::StateSet::USE_RENDERBIN_DETAILS);
    _stateSet->setNestRenderBins(false);
    _stateSet->setMode(GL_BLEND, OFF);
    _stateSet->setMode(GL_CULL_FACE, OFF);
    _stateSet->setMode(GL_ALPHA_TEST, OFF);
    _stateSet->setMode(GL_DEPTH_TEST, ON);
    _stateSet->setAttribute(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, true), ON);
    bindings::set(*_stateSet, bindings::CAPTURE_COLOUR,
                  static_cast<int>(bindings::UNIT_CAPTURE_COLOUR));
    bindings::set(*_stateSet, bindings::CAPTURE_WINDOW_Z,
                  static_cast<int>(bindings::UNIT_CAPTURE_WINDOW_Z));
    bindings::set(*_stateSet, bindings::SKY, static_cast<int>(bindings::UNIT_SKY));
}

void SheetPass::setCapture(const Capture& capture)
{
    _stateSet->setTextureAttribute(bindings::UNIT_CAPTURE_COLOUR, capture.colour(), ON);
    _stateSet->setTextureAttribute(bindings::UNIT_CAPTURE_WINDOW_Z, capture.windowZ(), ON);
    bindings::set(*_stateSet, bindings::CAPTURE_SIZE,
                  osg::Vec2(capture.colour()->getTextureWidth(),
                            capture.colour()->getTextureHeight()));

    const glm::dmat4& clipFromEye = capture.clipFromEye();
    const bool orthographic = eyePointOf(clipFromEye).w == 0.0;
    const double perspectiveScale = orthographic ? 0.0 : 0.5 * std::abs(clipFromEye[3][2]);
    const double orthographicScale = orthographic ? 0.5 * std::abs(clipFromEye[2][2]) : 0.0;
    bindings::set(*_stateSet, bindings::CAPTURE_CLIP_FROM_EYE, toOsgFloat(clipFromEye));
    bindings::set(*_stateSet, bindings::CAPTURE_DEPTH_SCALE,
                  osg::Vec2(perspectiveScale, orthographicScale));

    const osg::Vec4& clear = capture.clearColour();
    bindings::set(*_stateSet, bindings::CLEAR_COLOUR, osg::Vec3(clear.r(), clear.g(), clear.b()));
}

void SheetPass::setWater(const WaterSurface& water)
{
    const WaveModel* waves = water.getWaves();
    const std::string wavesShader = waves ? waves->getShaderName() : CALM_SHADER;
    if (wavesShader != _wavesShader)
    {
        _stateSet->setAttributeAndModes(waterProgram(wavesShader), ON);
        _wavesShader = wavesShader;
    }

    osg::TextureCubeMap* sky = const_cast<osg::TextureCubeMap*>(water.getSky());
    setVariant(*_stateSet, water.getReflection().search,
               sky ? SkySource::CUBE_MAP : SkySource::CAPTURED, water.getDebugView());
    if (sky)
        _stateSet->setTextureAttribute(bindings::UNIT_SKY, sky, ON);
    else
        _stateSet->removeTextureAttribute(bindings::UNIT_SKY, osg::StateAttribute::TEXTURE);

    bindings::set(*_stateSet, bindings::THICKNESS,
                  static_cast<float>(water.getReflection().thickness));
    bindings::set(*_stateSet, bindings::STRIDE, static_cast<float>(water.getReflection().stride));
    bindings::set(*_stateSet, bindings::REFRACTIVE_INDEX,
                  static_cast<float>(water.getOptics().refractiveIndex));
    bindings::set(*_stateSet, bindings::WATER_COLOUR, water.getOptics().waterColour);
}

void SheetPass::draw(osgUtil::CullVisitor& view, const Capture& capture, const WaterSurface& water,
                     const StillWater& sheet)
{
    setCapture(capture);
    setWater(water);

    const glm::dmat4 eyeFromLocal = fromOsg(*view.getModelViewMatrix());
    const glm::dmat4 eyeFromSurface = eyeFromLocal * sheet.localFromSurface();
    const glm::dmat4 clipFromEye = fromOsg(*view.getProjectionMatrix());
    const glm::dvec4 eyePointEye = eyePointOf(clipFromEye);
    const double time = view.getFrameStamp() ? view.getFrameStamp()->getSimulationTime() : 0.0;

    osg::Geometry* mesh = sheet.calmMesh();
    glm::dvec2 anchor = sheet.calmAnchor();
    double waterHeight = 0.0; // at the eye
    const glm::dvec4 eyeSurface = glm::inverse(eyeFromSurface) * eyePointEye;
    if (const WaveModel* waves = water.getWaves())
    {
        SheetView sheetView;
        sheetView.eyeFromSurface = eyeFromSurface;
        sheetView.clipFromEye = clipFromEye;
        sheetView.viewportWidth = view.getViewport()->width();
        sheetView.viewportHeight = view.getViewport()->height();
        sheetView.amplitude = waves->getAmplitude();
        sheetView.shortestEdge = waves->getShortestLength() / EDGES_PER_WAVE;
        if (!_waveMesh) _waveMesh = new WaveMesh;
        _waveMesh->update(sheet, sheetView, water.getDetail());
        mesh = _waveMesh->geometry();
        anchor = _waveMesh->anchor();
        waves->apply(*_stateSet, osg::Vec2d(anchor.x, anchor.y), time);
        if (eyeSurface.w != 0.0)
            waterHeight = waves->getHeight(osg::Vec2d(eyeSurface.x, eyeSurface.y), time);
    }

    const glm::dmat4 eyeFromAnchor = glm::translate(eyeFromSurface, glm::dvec3(anchor, 0.0));
    const glm::dmat4 worldFromEye =
        glm::inverse(fromOsg(*view.getCurrentRenderStage()->getInitialViewMatrix()));
    const double heightOfEye = eyeSurface.z - eyeSurface.w * waterHeight;
    bindings::set(*_stateSet, bindings::EYE_POINT_EYE,
                  osg::Vec4(eyePointEye.x, eyePointEye.y, eyePointEye.z, eyePointEye.w));
    bindings::set(*_stateSet, bindings::WORLD_FROM_EYE, toOsgFloat(glm::dmat3(worldFromEye)));
    bindings::set(*_stateSet, bindings::NORMAL_EYE_FROM_SURFACE,
                  toOsgFloat(normalMatrix(eyeFromSurface)));
    bindings::set(*_stateSet, bindings::SURFACE_FROM_EYE, toOsgFloat(glm::inverse(eyeFromAnchor)));
    bindings::set(*_stateSet, bindings::SIDE, heightOfEye < 0.0 ? -1.0f : 1.0f);

    const osg::BoundingBox bound =
        sheet.localBound(water.getWaves() ? water.getWaves()->getAmplitude() : 0.0);
    view.updateCalculatedNearFar(*view.getModelViewMatrix(), bound);
    view.pushStateSet(_stateSet.get());
    view.addDrawableAndDepth(mesh, new osg::RefMatrix(toOsg(eyeFromAnchor)),
                             view.getDistanceFromEyePoint(bound.center(), true));
    view.popStateSet();
}

void SheetPass::releaseGLObjects(osg::State* state) const
{
    _stateSet->releaseGLObjects(state);
    if (_waveMesh) _waveMesh->geometry()->releaseGLObjects(state);
}

void SheetPass::resizeGLObjectBuffers(unsigned int maxSize)
{
    _stateSet->resizeGLObjectBuffers(maxSize);
    if (_waveMesh) _waveMesh->geometry()->resizeGLObjectBuffers(maxSize);
}
