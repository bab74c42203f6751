#ifndef OSGWATERBENCH_SCENES_H
#define OSGWATERBENCH_SCENES_H

#include <osg/Group>
#include <osg/Vec3d>

#include <osgWaterReflect/WaterSurface>

#include <optional>
#include <string>
#include <vector>

namespace osgwaterbench
{

/// A scene to measure water in. Metres, z up; colours are baked (no lighting): vertex colours times
/// the texture of unit 0, so that reference::SceneTracer knows them. All but the sky writes depth.
struct BenchScene
{
    std::string name;
    osg::ref_ptr<osg::Group> scene;                    ///< without its water
    osg::ref_ptr<osgWaterReflect::WaterSurface> water; ///< calm, not a child of scene; has its sky
    double waterLevel = 0.0;                           ///< [m] z of the still water
    osg::Vec3d eye, centre;                            ///< [m]; up is z
    double fovyDegrees = 0.0;                          ///< vertical
};

/// lake, floating, street, branch, boxes and boxes-branch.
std::vector<std::string> sceneNames();

/// None, with a message, for another name and where data is missing.
std::optional<BenchScene> createScene(const std::string& name);

/// Waves that suit a scene of sceneNames() or the scaling scene. The boxes get the waves that were
/// measured with before (HarnessWaves), all others a breeze of the same root mean square slope.
/// Null for slope 0 and, with a message, for another name, a slope that is out of range, and where
/// data is missing.
///   slope  [1] what multiplies the slopes of data/bench/boxes.json; 0.05 ripples, 0.15 is choppy
osg::ref_ptr<osgWaterReflect::WaveModel> createWaves(const std::string& sceneName, double slope);

/// For measuring how the cost grows: hills and towers behind and in a lake, in 58 drawables, that
/// look the same whatever the number of triangles, since flat faces are divided ever finer. The
/// number is met to 0.5 %. Null, with a message, outside [1e3, 1e7].
osg::ref_ptr<osg::Group> createComplexScene(std::size_t triangles);

/// The same as a scene named "scaling" with a sky (12 triangles more), a rectangle of water and a
/// camera that sees all of its depth. Without a scene, with a message, where that is refused or
/// data is missing.
BenchScene createScalingScene(std::size_t triangles);

/// The scaling scene's rectangle of water divided into strips that lie across the view, every one
/// of them in sight. None, with a message, outside [1, 64] and where data is missing.
std::vector<osg::ref_ptr<osgWaterReflect::WaterSurface>> createWaters(int count);

/// The scaling scene's water in one piece of the same area with an outline of so many corners: its
/// far edge, which the land hides, is notched, so that calm water looks the same, too. Null, with a
/// message, for fewer than 4 and where data is missing.
osg::ref_ptr<osgWaterReflect::WaterSurface> createShapedWater(int corners);

} // namespace osgwaterbench

#endif
