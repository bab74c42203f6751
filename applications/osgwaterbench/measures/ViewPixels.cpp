#include "ViewPixels.h"

#include <osgWaterReflect/Transforms.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

using namespace osgwaterbench;

namespace
{

// Of the image's half size, from its middle: half the image's size beside it.
const double WIDE = 2.0;

// Angle between two vectors of any length [rad], exact for small ones too.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

ViewPixels::ViewPixels(const DrawnWater& drawn) :
    _view(drawn.view), _eyeFromWorld(drawn.eyeFromWorld),
    _worldFromEye(glm::inverse(drawn.eyeFromWorld)),
    _orthographic(osgWaterReflect::eyePointOf(drawn.view.clipFromEye).w == 0.0),
    _sideAtOne(2.0 / (drawn.view.size.y * drawn.view.clipFromEye[1][1]))
{
}

glm::dvec4 ViewPixels::clip(const glm::dvec3& placeWorld) const
{
    return _view.clipFromEye * (_eyeFromWorld * glm::dvec4(placeWorld, 1.0));
}

bool ViewPixels::isAhead(const glm::dvec3& placeWorld) const
{
    const glm::dvec4 place = clip(placeWorld);
    return place.w > 0.0 && place.z >= -place.w;
}

glm::dvec2 ViewPixels::window(const glm::dvec3& placeWorld) const
{
    const glm::dvec4 place = clip(placeWorld);
    return (glm::dvec2(place) / place.w * 0.5 + 0.5) * _view.size;
}

bool ViewPixels::inImage(const glm::dvec2& window) const
{
    return window.x >= 0.5 && window.x <= _view.size.x - 0.5 && window.y >= 0.5 &&
           window.y <= _view.size.y - 0.5;
}

glm::dvec3 ViewPixels::nearPlace(const glm::dvec2& window) const
{
    return glm::dvec3(_worldFromEye *
                      glm::dvec4(_view.eyeFromWindow(glm::dvec3(window, 0.0)), 1.0));
}

bool ViewPixels::inWideImage(const glm::dvec4& clip) const
{
    return clip.w > 0.0 && std::abs(clip.x) <= WIDE * clip.w && std::abs(clip.y) <= WIDE * clip.w;
}

double ViewPixels::distance(const glm::dvec3& aWorld, const glm::dvec3& bWorld) const
{
    double pixels = 0.0;
    if (_orthographic || (inWideImage(clip(aWorld)) && inWideImage(clip(bWorld))))
        pixels = glm::length(window(aWorld) - window(bWorld));
    else
        pixels = angleBetween(glm::dvec3(_eyeFromWorld * glm::dvec4(aWorld, 1.0)),
                              glm::dvec3(_eyeFromWorld * glm::dvec4(bWorld, 1.0))) /
                 _sideAtOne;
    return std::isnan(pixels) ? std::numeric_limits<double>::infinity() : pixels;
}

double ViewPixels::pixelSide(const glm::dvec3& placeWorld) const
{
    if (_orthographic) return _sideAtOne;
    return _sideAtOne * glm::length(glm::dvec3(_eyeFromWorld * glm::dvec4(placeWorld, 1.0)));
}
