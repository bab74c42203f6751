#ifndef OSGWATERVIEWER_SCENE_H
#define OSGWATERVIEWER_SCENE_H

#include "Options.h"
#include "WaterGeodes.h"

namespace osgwaterviewer
{

/// The models, their water, and where they are looked at from.
struct Scene
{
    osg::ref_ptr<osg::Group> root;
    Waters waters;
    WaterLook look;                                 ///< of the waters
    osg::ref_ptr<osgWaterReflect::WaveModel> waves; ///< what moves them, if they are to move
    std::string models;                             ///< their files' names, for reports
    HomeView home;
    double fovyDegrees;
};

/// Reads the models, or else the lake, and makes water of what is to be water. Empty, with a
/// message, where something cannot be read.
///   fovyDegrees   the view's own, for scenes that ask for no other
std::optional<Scene> createScene(const Options& options, double fovyDegrees);

} // namespace osgwaterviewer

#endif
