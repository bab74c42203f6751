#include "SkyImage.h"

#include "../shaders/Bindings.h"

#include <glm/vec4.hpp>

using namespace osgWaterReflect;

namespace
{

// As in shaders/shared/interface.glsl.
const int SKY_BLOCK = 16;

const char* const FIND_SKY = "sky_above.frag";

glm::ivec2 blocksOver(const glm::ivec2& size)
{
    return (size + SKY_BLOCK - 1) / SKY_BLOCK;
}

} // namespace

SkyImage::SkyImage() : _pass(new ImagePass(FIND_SKY, GL_RGBA32F_ARB, GL_RGBA))
{
    _pass->image()->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    _pass->image()->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
}

osg::ref_ptr<osg::Program> SkyImage::program()
{
    return ImagePass::program(FIND_SKY);
}

void SkyImage::compute(const Capture& capture, const glm::dvec3& upEye)
{
    const glm::dvec4 up = capture.clipFromEye() * glm::dvec4(upEye, 0.0);
    _pass->setInput(0, bindings::SKY_SOURCE_COLOUR, capture.colour());
    _pass->setInput(1, bindings::SKY_SOURCE_WINDOW_Z, capture.windowZ());
    bindings::set(_pass->stateSet(), bindings::SKY_SOURCE_SIZE,
                  osg::Vec2(capture.size().x, capture.size().y));
    bindings::set(_pass->stateSet(), bindings::SKY_UP, osg::Vec3(up.x, up.y, up.w));
    _pass->require(capture.stage(), blocksOver(capture.size()), blocksOver(capture.capacity()));
}
