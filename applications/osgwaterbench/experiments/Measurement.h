#ifndef OSGWATERBENCH_MEASUREMENT_H
#define OSGWATERBENCH_MEASUREMENT_H

#include "../measures/Measures.h"
#include "../measures/PictureError.h"
#include "../measures/SearchError.h"
#include "../measures/TessellationError.h"
#include "../render/BenchView.h"

#include <glm/mat4x4.hpp>

#include <map>
#include <optional>
#include <utility>

namespace osgwaterbench
{

/// How good one method is in one scene.
struct Accuracy
{
    Measures measures;
    std::optional<SearchError> search; ///< none of a method that searches other images
    PictureError picture;
};

/// One scene with one kind of waves and the truth about it, in which methods are measured.
class Measurement
{
public:
    /// waves  null for calm water
    Measurement(const BenchScene& scene, osgWaterReflect::WaveModel* waves, const glm::ivec2& size);

    std::size_t waterPixels() const { return _truth.size(); }

    Accuracy measure(const Method& method);

    /// As measure() has it, without the rest.
    Measures measurePlaces(const Method& method);

    /// None on calm water, which the mesh meets.
    std::optional<TessellationError> tessellation() const;

    Picture picture(const Method& method); ///< as it is drawn
    Picture truePicture() const { return _truePicture; }
    const std::vector<std::uint8_t>& isWater() const { return _drawn.isWater; }

private:
    Measures placesOf(const Answers& answers) const;

    /// Of the view's capture in the last frame. What it shows depends on its size alone.
    const ImageTruth& imageTruth();

    BenchView _view;
    osg::ref_ptr<osgWaterReflect::WaveModel> _waves;
    osgWaterReflect::reference::SceneTracer _tracer;
    DrawnWater _drawn;
    Truth _truth;
    std::map<std::pair<int, int>, ImageTruth> _imageTruths; // by the size of the capture
    Picture _truePicture;
    glm::dmat4 _eyeFromSurface{1.0};
};

} // namespace osgwaterbench

#endif
