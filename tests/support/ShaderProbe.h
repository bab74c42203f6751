#ifndef OSGWATERREFLECT_TESTS_SUPPORT_SHADERPROBE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_SHADERPROBE_H

#include "OffscreenView.h"

#include <osgWaterReflect/shaders/ShaderSlots.h>

#include <osg/Vec4>

#include <string>
#include <vector>

/// Evaluates a function of the library's own shader pieces on the GPU, once per input, in single
/// precision: each pixel of a full-screen quad is one input, and its colour is the answer.
class ShaderProbe
{
public:
    /// functions: GLSL that defines `vec4 probe(vec4 first, vec4 second)`; it may include pieces
    /// and slots of shaders/.
    explicit ShaderProbe(const std::string& functions,
                         const osgWaterReflect::ShaderSlots& slots = {});

    /// Uniforms of the pieces are set here.
    osg::StateSet& stateSet() { return *_stateSet; }

    /// The answers, in the order of the inputs. second may be left out: zeros then.
    std::vector<osg::Vec4> run(const std::vector<osg::Vec4>& first,
                               const std::vector<osg::Vec4>& second = {});

private:
    static constexpr int SIDE = 256;

    OffscreenView _view;
    osg::ref_ptr<osg::Group> _scene;
    osg::ref_ptr<osg::StateSet> _stateSet;
};

#endif
