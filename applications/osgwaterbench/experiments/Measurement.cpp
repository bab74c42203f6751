#include "Measurement.h"

#include "../render/Readback.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/gtc/matrix_transform.hpp>

using namespace osgwaterbench;
using DebugView = osgWaterReflect::WaterSurface::DebugView;

Measurement::Measurement(const BenchScene& scene, osgWaterReflect::WaveModel* waves,
                         const glm::ivec2& size) :
    _view(scene, size, BenchView::Purpose::MEASURE),
    _waves(waves), _tracer(*scene.scene)
{
    const Method own = libraryMethod("default", searchOfView());
    _view.setWaves(waves);
    _view.setMethod(own);
    _drawn = readDrawnWater(_view);
    const SkyLookup sky(*scene.water->getSky());
    _truth = findTruth(_drawn, {_tracer, sky, scene.water->getOptics()});
    _truePicture = withTruth(picture(own), _truth);
    _eyeFromSurface = glm::translate(_drawn.eyeFromWorld, glm::dvec3(0.0, 0.0, scene.waterLevel));
}

Picture Measurement::picture(const Method& method)
{
    _view.setMethod(method);
    return pictureOf(_view.render(DebugView::NONE));
}

Measures Measurement::measurePlaces(const Method& method)
{
    _view.setMethod(method);
    return placesOf(readAnswers(_view));
}

// One measure for all methods: the thickness is the library's default.
Measures Measurement::placesOf(const Answers& answers) const
{
    return osgwaterbench::measure(_drawn, _truth, answers,
                                  osgWaterReflect::ReflectionSettings().thickness);
}

const ImageTruth& Measurement::imageTruth()
{
    _drawn.capture = readCapture(_view);
    const glm::ivec2 size(_drawn.capture.geometry.size);
    const auto found = _imageTruths.try_emplace({size.x, size.y});
    if (found.second)
        found.first->second =
            findImageTruth(_drawn, osgWaterReflect::ReflectionSettings().thickness);
    return found.first->second;
}

Accuracy Measurement::measure(const Method& method)
{
    _view.setMethod(method);
    const Answers answers = readAnswers(_view);
    Accuracy accuracy;
    accuracy.measures = placesOf(answers);
    const bool searchesView =
        method.usesCapture && (method.settings.capture == osgWaterReflect::CaptureKind::VIEW ||
                               method.settings.capture == osgWaterReflect::CaptureKind::FRAME);
    if (searchesView) accuracy.search = compareSearch(_drawn, imageTruth(), answers);
    accuracy.picture =
        comparePictures(picture(method), _truePicture, _drawn.isWater).value_or(PictureError());
    return accuracy;
}

std::optional<TessellationError> Measurement::tessellation() const
{
    if (!_waves) return std::nullopt;
    return measureTessellation(_drawn, {*_waves, 0.0, _eyeFromSurface}, _tracer);
}
