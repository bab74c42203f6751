#ifndef OSGWATERVIEWER_DEMOSCENES_H
#define OSGWATERVIEWER_DEMOSCENES_H

#include "HomeView.h"

#include <string>

namespace osgwaterviewer
{

/// A scene of the data directory, whose best view is known.
struct DemoScene
{
    const char* file; ///< in the data directory
    HomeView home;
    double fovyDegrees;
};

/// The data directory's place is that of the source tree, or what this variable says.
extern const char* const DATA_VARIABLE;
std::string dataDirectory();

/// The file of the scene that is shown where no model is given.
std::string defaultModel();

/// The directory of the demo scenes' sky.
std::string demoSkyDirectory();

/// Null where a file is not a demo scene.
const DemoScene* findDemoScene(const std::string& file);

} // namespace osgwaterviewer

#endif
