#include "DrawnStillWater.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using osgwaterbench::DrawnWater;

glm::dmat4 ViewAhead::eyeFromWorld() const
{
    const double pitch = glm::radians(pitchDegrees);
    return glm::lookAt(eye, eye + glm::dvec3(0.0, std::cos(pitch), -std::sin(pitch)),
                       glm::dvec3(0.0, 0.0, 1.0));
}

glm::dmat4 ViewAhead::clipFromEye() const
{
    return glm::perspective(glm::radians(fovyDegrees), static_cast<double>(width) / height, 0.1,
                            1000.0);
}

DrawnWater drawStillWater(const ViewAhead& view,
                          const std::function<bool(const glm::dvec3&)>& isWater, double level)
{
    DrawnWater drawn;
    drawn.view = {view.clipFromEye(), glm::dvec2(view.width, view.height)};
    drawn.eyeFromWorld = view.eyeFromWorld();
    drawn.stillNormalEye = glm::dvec3(drawn.eyeFromWorld[2]);
    const std::size_t count = static_cast<std::size_t>(view.width) * view.height;
    drawn.isWater.assign(count, 0);
    drawn.pointEye.assign(count, glm::dvec3(0.0));
    drawn.normalEye.assign(count, drawn.stillNormalEye);
    for (std::size_t pixel = 0; pixel < count; ++pixel)
    {
        const glm::dvec2 window(pixel % view.width + 0.5, pixel / view.width + 0.5);
        const glm::dvec3 sight = placeAtWindow(drawn, window, 1.0) - view.eye;
        if (sight.z >= 0.0) continue;
        glm::dvec3 place = view.eye + sight * ((level - view.eye.z) / sight.z);
        place.z = level;
        drawn.isWater[pixel] = isWater(place);
        drawn.pointEye[pixel] = glm::dvec3(drawn.eyeFromWorld * glm::dvec4(place, 1.0));
    }
    return drawn;
}

glm::dvec3 waterPoint(const DrawnWater& drawn, std::size_t pixel)
{
    return glm::dvec3(glm::inverse(drawn.eyeFromWorld) * glm::dvec4(drawn.pointEye[pixel], 1.0));
}

glm::dvec3 placeAtWindow(const DrawnWater& drawn, const glm::dvec2& window, double depth)
{
    // A symmetric frustum's, written out.
    const glm::dvec2 ndc = window / drawn.view.size * 2.0 - 1.0;
    const glm::dmat4& clipFromEye = drawn.view.clipFromEye;
    const glm::dvec3 eye(ndc.x * depth / clipFromEye[0][0], ndc.y * depth / clipFromEye[1][1],
                         -depth);
    return glm::dvec3(glm::inverse(drawn.eyeFromWorld) * glm::dvec4(eye, 1.0));
}
