#ifndef OSGWATERBENCH_METHODS_H
#define OSGWATERBENCH_METHODS_H

#include "MirrorCamera.h"

#include <osgWaterReflect/water/WaterSettings.h>

#include <map>
#include <optional>
#include <string>

namespace osgwaterbench
{

/// The files of shaders/, compiled in: text by file name.
extern const std::map<std::string, std::string> benchShaders;

/// A way to find what water reflects. All methods are drawn by the library's water, so that waves,
/// Fresnel's law, sky and shading are the same; one that is not the library's puts other pieces in
/// the place of the shader's.
///
/// Whatever the method, DebugView::HIT puts out the place shown in the image that it searches (the
/// capture, or the mirrored image), (-1, -1) for the sky, and the depths it fetched.
struct Method
{
    std::string name;
    osgWaterReflect::WaterSettings settings;
    std::map<std::string, std::string> pieces; ///< in the place of the library's, and more of them
    std::optional<MirrorLook> mirror;          ///< a mirrored camera instead of the capture
    bool usesCapture = true;                   ///< else the scene is kept out of it
};

/// The library's default settings, but for what is AUTOMATIC: the hierarchical search in the view's
/// own image, in every view.
osgWaterReflect::WaterSettings searchOfView();

/// The library's own, with any settings.
Method libraryMethod(const std::string& name, const osgWaterReflect::WaterSettings& settings);

/// "paper": the sequential search of Li and Luo, literally. Perspective views only.
Method paperMethod();

/// "paper-binary": their binary search, by the same test. Perspective views only.
Method paperBinaryMethod();

/// "baseline": what most screen-space reflections start from: every column, one pixel in each,
/// linear depths and a thickness of 2 world units. Perspective views only.
Method baselineMethod();

/// "sky-only": no search; water that reflects the sky and nothing else.
Method skyOnlyMethod();

/// "mirror" or "mirror-over-distance": a mirrored camera, its image bent by the waves' normals.
/// It wants a cube map for the sky: what the scene draws without depth is not captured.
Method mirrorMethod(const MirrorLook& look);

} // namespace osgwaterbench

#endif
