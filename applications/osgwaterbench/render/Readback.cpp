#include "Readback.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/matrix.hpp>

using namespace osgwaterbench;
using osgWaterReflect::fromOsg;
using DebugView = osgWaterReflect::WaterSurface::DebugView;

namespace
{

// What DebugView::POINT and NORMAL put into alpha; no scene's colour has it.
const float WATER_ALPHA = -1.0f;

// What DebugView::HIT adds to the reason where the second capture shows the colour.
const float SECOND_CAPTURE = 16.0f;

const float* floatsOf(const osg::Image& image, std::size_t pixel)
{
    return reinterpret_cast<const float*>(image.data()) + 4 * pixel;
}

glm::dvec3 vec3Of(const float* values)
{
    return glm::dvec3(values[0], values[1], values[2]);
}

// Places of the world in a searched image.
class SearchedPlaces
{
public:
    explicit SearchedPlaces(const SearchedImage& image) :
        _image(image), _size(image.windowZ->s(), image.windowZ->t()),
        _worldFromClip(glm::inverse(fromOsg(image.clipFromEye) * fromOsg(image.eyeFromWorld)))
    {
    }

    Answer answer(const glm::dvec2& window, float fetches) const
    {
        Answer answer;
        answer.fetches = fetches;
        if (window.x < 0.0) return answer;
        const glm::ivec2 pixel = glm::clamp(glm::ivec2(window), glm::ivec2(0), _size - 1);
        const auto* windowZs = reinterpret_cast<const float*>(_image.windowZ->data());
        const double windowZ = windowZs[pixel.y * _size.x + pixel.x];
        if (windowZ >= 1.0) return answer; // beside an edge: its colour is the background's
        answer.sky = false;
        const glm::dvec3 ndc = 2.0 * glm::dvec3(window / glm::dvec2(_size), windowZ) - 1.0;
        const glm::dvec4 world = _worldFromClip * glm::dvec4(ndc, 1.0);
        answer.placeWorld = glm::dvec3(world) / world.w;
        return answer;
    }

private:
    const SearchedImage& _image;
    glm::ivec2 _size;
    glm::dmat4 _worldFromClip;
};

} // namespace

DrawnWater osgwaterbench::readDrawnWater(BenchView& view)
{
    const std::size_t count = static_cast<std::size_t>(view.size().x) * view.size().y;
    DrawnWater drawn;
    drawn.isWater.resize(count);
    drawn.pointEye.resize(count);
    drawn.normalEye.resize(count);

    const osg::Image& points = view.render(DebugView::POINT);
    for (std::size_t i = 0; i < count; ++i)
    {
        const float* const values = floatsOf(points, i);
        drawn.isWater[i] = values[3] == WATER_ALPHA;
        if (drawn.isWater[i]) drawn.pointEye[i] = vec3Of(values);
    }
    const osg::Image& normals = view.render(DebugView::NORMAL);
    for (std::size_t i = 0; i < count; ++i)
        if (drawn.isWater[i]) drawn.normalEye[i] = vec3Of(floatsOf(normals, i));

    const glm::dvec2 size(view.size());
    drawn.eyeFromWorld = fromOsg(view.camera().getViewMatrix());
    drawn.view = {fromOsg(view.camera().getProjectionMatrix()), size};
    drawn.capture = readCapture(view);
    drawn.stillNormalEye = glm::dvec3(drawn.eyeFromWorld * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    return drawn;
}

osgWaterReflect::reference::CapturedImage osgwaterbench::readCapture(BenchView& view)
{
    const SearchedImage image = view.searchedImages().front();
    const glm::ivec2 size(image.windowZ->s(), image.windowZ->t());
    const auto* windowZ = reinterpret_cast<const float*>(image.windowZ->data());
    osgWaterReflect::reference::CapturedImage capture;
    capture.geometry = {fromOsg(image.clipFromEye), glm::dvec2(size)};
    capture.windowZ.assign(windowZ, windowZ + static_cast<std::size_t>(size.x) * size.y);
    return capture;
}

Answers osgwaterbench::readAnswers(BenchView& view)
{
    const osg::Image& hits = view.render(DebugView::HIT);
    const std::vector<SearchedImage> images = view.searchedImages();
    const std::vector<SearchedPlaces> places(images.begin(), images.end());
    Answers answers(static_cast<std::size_t>(view.size().x) * view.size().y);
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        const float* const hit = floatsOf(hits, i);
        const std::size_t capture = hit[2] >= SECOND_CAPTURE ? 1 : 0;
        answers[i] = places.at(capture).answer(glm::dvec2(hit[0], hit[1]), hit[3]);
    }
    return answers;
}
