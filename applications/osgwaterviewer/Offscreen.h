#ifndef OSGWATERVIEWER_OFFSCREEN_H
#define OSGWATERVIEWER_OFFSCREEN_H

#include "Scene.h"

#include <osgViewer/Viewer>

namespace osgwaterviewer
{

/// Renders a picture of the scene without any display, writes it and reports what was done. Returns
/// the program's exit status.
int renderOffscreen(osgViewer::Viewer& viewer, const Scene& scene, const Picture& picture);

} // namespace osgwaterviewer

#endif
