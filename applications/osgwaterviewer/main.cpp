#include "DemoScenes.h"
#include "Offscreen.h"
#include "Options.h"
#include "Scene.h"
#include "Window.h"

#include <osgWaterReflect/CompileShaders>

#include <iostream>

using namespace osgwaterviewer;

namespace
{

void describeProgram(osg::ApplicationUsage& usage)
{
    const std::string name = "osgwaterviewer";
    usage.setApplicationName(name);
    usage.setDescription(name + " shows models with water that reflects them; without a model, a "
                                "lake.");
    usage.setCommandLineUsage(name + " [options] [filename ...]");
    usage.addEnvironmentalVariable(std::string(DATA_VARIABLE) + " <directory>",
                                   "Where the lake, the street and their sky are. [" +
                                       dataDirectory() + "]");
}

int writeHelp(osgViewer::Viewer& viewer, osg::ApplicationUsage& usage, unsigned int help)
{
    addManipulators(viewer, HomeView(), "");
    addHandlers(viewer, &usage, {}, nullptr);
    viewer.getUsage(usage);
    usage.write(std::cout, help);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    osg::ArgumentParser arguments(&argc, argv);
    osg::ApplicationUsage& usage = *arguments.getApplicationUsage();
    describeProgram(usage);
    osgViewer::Viewer viewer(arguments); // takes the options that every viewer of OSG has

    const std::optional<Options> options = readOptions(arguments);
    if (!options) return 1;
    if (options->help) return writeHelp(viewer, usage, options->help);

    const std::optional<Scene> scene = createScene(*options, fovyDegreesOf(*viewer.getCamera()));
    if (!scene) return 1;

    if (!options->picture.file.empty()) return renderOffscreen(viewer, *scene, options->picture);

    using osgWaterReflect::Search;
    viewer.setRealizeOperation(new osgWaterReflect::CompileShaders(
        {Search::SEQUENTIAL, Search::BINARY, Search::HIERARCHICAL})); // a key switches them
    if (!addManipulators(viewer, scene->home, options->pathFile)) return 1;
    addHandlers(viewer, &usage, scene->waters, scene->waves);
    return runInWindow(viewer, *scene);
}
