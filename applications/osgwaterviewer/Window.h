#ifndef OSGWATERVIEWER_WINDOW_H
#define OSGWATERVIEWER_WINDOW_H

#include "Scene.h"

#include <osgViewer/Viewer>

namespace osgwaterviewer
{

/// Adds osgviewer's handlers and the water's.
void addHandlers(osgViewer::Viewer& viewer, osg::ApplicationUsage* usage, const Waters& waters,
                 osgWaterReflect::WaveModel* waves);

/// Adds osgviewer's manipulators. False, with a message, where the path cannot be read.
///   pathFile   an animation path to follow, empty for none
bool addManipulators(osgViewer::Viewer& viewer, const HomeView& home, const std::string& pathFile);

/// Shows the scene until the user closes the window. Returns the program's exit status.
int runInWindow(osgViewer::Viewer& viewer, const Scene& scene);

} // namespace osgwaterviewer

#endif
