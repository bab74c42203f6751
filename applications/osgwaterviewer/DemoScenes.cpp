#include "DemoScenes.h"

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

#include <cstdlib>

using namespace osgwaterviewer;

namespace
{

// The first is the default. data/README.md has these views.
const DemoScene DEMO_SCENES[] = {{"lake.osgb", {{0.0, -30.0, 2.2}, {0.0, 0.0, 2.6}}, 46.0},
                                 {"street.osgb", {{-6.2, -3.6, 1.6}, {0.4, 4.0, 1.35}}, 50.0}};

std::string inDataDirectory(const std::string& file)
{
    return osgDB::concatPaths(dataDirectory(), file);
}

} // namespace

const char* const osgwaterviewer::DATA_VARIABLE = "OSGWATERREFLECT_DATA";

std::string osgwaterviewer::dataDirectory()
{
    const char* const directory = std::getenv(DATA_VARIABLE);
    return directory ? directory : OSGWATERREFLECT_DATA_DIRECTORY;
}

std::string osgwaterviewer::defaultModel()
{
    return inDataDirectory(DEMO_SCENES[0].file);
}

std::string osgwaterviewer::demoSkyDirectory()
{
    return inDataDirectory("sky");
}

const DemoScene* osgwaterviewer::findDemoScene(const std::string& file)
{
    const std::string path = osgDB::getRealPath(osgDB::findDataFile(file));
    for (const DemoScene& scene : DEMO_SCENES)
        if (path == osgDB::getRealPath(inDataDirectory(scene.file))) return &scene;
    return nullptr;
}
