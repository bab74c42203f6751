#ifndef OSGWATERVIEWER_OPTIONS_H
#define OSGWATERVIEWER_OPTIONS_H

#include "HomeView.h"
#include "OptionReader.h"
#include "WaterLevel.h"
#include "WaterLook.h"

#include <optional>
#include <string>
#include <vector>

namespace osgwaterviewer
{

/// The picture to be made in place of opening a window.
struct Picture
{
    std::string file;  ///< empty for none
    int width = 640;   ///< [pixels] > 0
    int height = 480;  ///< [pixels] > 0
    double time = 0.0; ///< [s] of the simulation
    int frames = 5;    ///< > 0; frames that are timed
};

/// What the command line asks for.
struct Options
{
    unsigned int help = 0; ///< osg::ApplicationUsage::Type of all that is to be listed, 0 for none
    std::vector<std::string> models;         ///< none for the lake
    std::optional<WaterLevel> waterLevel;    ///< of water to be laid through the models
    std::optional<std::string> skyDirectory; ///< empty for no sky; none for the scene's own
    std::optional<HomeView> camera;          ///< none for the scene's own
    std::optional<double> fovyDegrees;       ///< none for the scene's own
    std::string pathFile;                    ///< an animation path to follow, empty for none
    WaterLook look;
    Picture picture;
};

/// Reads every option. Empty, with a message, where there is a mistake.
std::optional<Options> readOptions(osg::ArgumentParser& arguments);

} // namespace osgwaterviewer

#endif
