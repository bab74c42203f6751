#include "Methods.h"

using namespace osgwaterbench;

namespace
{

// A method that replaces the library's trace by a file of shaders/, which includes others of them.
//   includedAs  a file by the name that it is included by, where that is not its own
Method replacingTrace(const std::string& name, const std::string& file,
                      const std::map<std::string, std::string>& includedAs = {})
{
    Method method;
    method.name = name;
    method.settings.capture = osgWaterReflect::CaptureKind::VIEW;
    method.settings.search = osgWaterReflect::Search::SEQUENTIAL; // which needs no pyramid
    method.settings.guardBand = osgWaterReflect::GuardBandKind::NONE;
    method.pieces["reflection.glsl"] = benchShaders.at(file);
    for (const char* helper : {"answer.glsl", "image_columns.glsl", "eye_depth.glsl"})
        method.pieces[helper] = benchShaders.at(helper);
    for (const auto& included : includedAs)
        method.pieces[included.first] = benchShaders.at(included.second);
    return method;
}

} // namespace

osgWaterReflect::WaterSettings osgwaterbench::searchOfView()
{
    osgWaterReflect::WaterSettings settings;
    settings.search = osgWaterReflect::Search::HIERARCHICAL;
    settings.capture = osgWaterReflect::CaptureKind::VIEW;
    return settings;
}

Method osgwaterbench::libraryMethod(const std::string& name,
                                    const osgWaterReflect::WaterSettings& settings)
{
    Method method;
    method.name = name;
    method.settings = settings;
    return method;
}

Method osgwaterbench::paperMethod()
{
    return replacingTrace("paper", "reflection_paper.glsl",
                          {{"paper_search.glsl", "paper_sequential.glsl"}});
}

Method osgwaterbench::paperBinaryMethod()
{
    return replacingTrace("paper-binary", "reflection_paper.glsl",
                          {{"paper_search.glsl", "paper_binary.glsl"}});
}

Method osgwaterbench::baselineMethod()
{
    Method method = replacingTrace("baseline", "reflection_baseline.glsl");
    method.settings.thickness = 2.0;
    return method;
}

Method osgwaterbench::skyOnlyMethod()
{
    Method method = replacingTrace("sky-only", "reflection_sky.glsl");
    method.usesCapture = false;
    return method;
}

Method osgwaterbench::mirrorMethod(const MirrorLook& look)
{
    Method method = replacingTrace(look.overDistance ? "mirror-over-distance" : "mirror",
                                   "reflection_mirror.glsl");
    method.mirror = look;
    method.usesCapture = false;
    return method;
}
