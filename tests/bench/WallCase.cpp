#include "WallCase.h"

#include "support/Scenes.h"

#include <cmath>

using namespace osgwaterbench;

WallCase::WallCase() :
    drawn(drawStillWater(view, [this](const glm::dvec3& place) { return place.y < distance; })),
    node(scenes::createQuad(osg::Vec3(-halfWidth, distance, 0.0), osg::Vec3(2.0 * halfWidth, 0, 0),
                            osg::Vec3(0, 0, height), osg::Vec4(colour.r, colour.g, colour.b, 1.0))),
    scene(*node), sky(skyColour), world{scene, sky, {}}, truth(findTruth(drawn, world))
{
}

glm::dvec3 WallCase::mirrored(std::size_t pixel) const
{
    const glm::dvec3 eye(view.eye.x, view.eye.y, -view.eye.z);
    const glm::dvec3 way = waterPoint(drawn, pixel) - eye;
    return eye + way * ((distance - eye.y) / way.y);
}

bool WallCase::onWall(const glm::dvec3& place) const
{
    return std::abs(place.x) <= halfWidth && place.z <= height;
}

glm::dvec3 WallCase::beside(const glm::dvec3& place, const glm::dvec2& pixels) const
{
    const glm::dvec2 window(
        drawn.view.windowFromEye(glm::dvec3(drawn.eyeFromWorld * glm::dvec4(place, 1.0))));
    const glm::dvec3 way = placeAtWindow(drawn, window + pixels, 1.0) - view.eye;
    return view.eye + way * ((distance - view.eye.y) / way.y);
}

Answers WallCase::rightAnswers() const
{
    Answers answers(drawn.isWater.size());
    for (std::size_t pixel = 0; pixel < answers.size(); ++pixel)
    {
        if (!drawn.isWater[pixel]) continue;
        const glm::dvec3 place = mirrored(pixel);
        answers[pixel] = {!onWall(place), place, 8.0f};
    }
    return answers;
}
