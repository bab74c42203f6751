#include "CaptureBinding.h"

#include "../Transforms.h"
#include "../shaders/Bindings.h"

using namespace osgWaterReflect;

namespace
{

const unsigned int ON = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;

template <typename Value>
osg::ref_ptr<osg::Uniform> createUniform(const std::string& name, const Value& value)
{
    return new osg::Uniform(name.c_str(), value);
}

} // namespace

CaptureBinding::CaptureBinding(const std::string& name, unsigned int unit) :
    _unit(unit), _colour(createUniform(name + bindings::COLOUR, static_cast<int>(unit))),
    _windowZ(createUniform(name + bindings::WINDOW_Z, static_cast<int>(unit + 1))),
    _cells(createUniform(name + bindings::CELLS, static_cast<int>(unit + 2))),
    _sky(createUniform(name + bindings::SKY, static_cast<int>(unit + 3))),
    _size(createUniform(name + bindings::SIZE, osg::Vec2())),
    _imageFromEye(createUniform(name + bindings::IMAGE_FROM_EYE, osg::Matrixf())),
    _depthScale(createUniform(name + bindings::DEPTH_SCALE, osg::Vec2())),
    _pixelExtent(createUniform(name + bindings::PIXEL_EXTENT, 0.0f)),
    _mirrored(createUniform(name + bindings::MIRRORED, false))
{
}

void CaptureBinding::bind(osg::StateSet& stateSet, const Capture& capture, const DepthCells* cells,
                          const SkyImage* sky)
{
    if (!_bound)
        for (const auto& uniform : {_colour, _windowZ, _cells, _sky, _size, _imageFromEye,
                                    _depthScale, _pixelExtent, _mirrored})
            stateSet.addUniform(uniform, ON);
    _bound = true;
    bindTexture(stateSet, _unit, capture.colour());
    bindTexture(stateSet, _unit + 1, capture.windowZ());
    bindTexture(stateSet, _unit + 2, cells ? cells->cells() : nullptr);
    bindTexture(stateSet, _unit + 3, sky ? sky->image() : nullptr);

    const Capture::DepthScale depthScale = capture.depthScale();
    _size->set(osg::Vec2(capture.size().x, capture.size().y));
    _imageFromEye->set(toOsgFloat(imageFromClip() * capture.clipFromEye()));
    _depthScale->set(osg::Vec2(depthScale.perspective, depthScale.orthographic));
    _pixelExtent->set(static_cast<float>(capture.pixelExtent()));
    _mirrored->set(capture.isMirrored());
}

void CaptureBinding::unbind(osg::StateSet& stateSet)
{
    if (!_bound) return;
    for (unsigned int unit = _unit; unit < _unit + NUM_UNITS; ++unit)
        bindTexture(stateSet, unit, nullptr);
}

void CaptureBinding::bindTexture(osg::StateSet& stateSet, unsigned int unit,
                                 osg::Texture2D* texture)
{
    if (stateSet.getTextureAttribute(unit, osg::StateAttribute::TEXTURE) == texture) return;
    if (texture)
        stateSet.setTextureAttribute(unit, texture, ON);
    else
        stateSet.removeTextureAttribute(unit, osg::StateAttribute::TEXTURE);
}
