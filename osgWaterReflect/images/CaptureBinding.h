#ifndef OSGWATERREFLECT_IMAGES_CAPTUREBINDING_H
#define OSGWATERREFLECT_IMAGES_CAPTUREBINDING_H

#include "../capture/Capture.h"
#include "DepthCells.h"
#include "SkyImage.h"

#include <osg/StateSet>
#include <osg/Uniform>

#include <string>

namespace osgWaterReflect
{

/// A capture in the state of what is drawn with it: its textures, and the uniform of the shader's
/// struct Capture.
class CaptureBinding
{
public:
    static constexpr unsigned int NUM_UNITS = 4;

    ///   name  of the uniform
    ///   unit  of the first of its textures
    CaptureBinding(const std::string& name, unsigned int unit);

    ///   cells, sky  of that capture; null where nothing reads them
    void bind(osg::StateSet& stateSet, const Capture& capture, const DepthCells* cells,
              const SkyImage* sky);

    /// Lets go of the textures.
    void unbind(osg::StateSet& stateSet);

private:
    void bindTexture(osg::StateSet& stateSet, unsigned int unit, osg::Texture2D* texture);

    const unsigned int _unit;
    bool _bound = false;
    const osg::ref_ptr<osg::Uniform> _colour;
    const osg::ref_ptr<osg::Uniform> _windowZ;
    const osg::ref_ptr<osg::Uniform> _cells;
    const osg::ref_ptr<osg::Uniform> _sky;
    const osg::ref_ptr<osg::Uniform> _size;
    const osg::ref_ptr<osg::Uniform> _imageFromEye;
    const osg::ref_ptr<osg::Uniform> _depthScale;
    const osg::ref_ptr<osg::Uniform> _pixelExtent;
    const osg::ref_ptr<osg::Uniform> _mirrored;
};

} // namespace osgWaterReflect

#endif
