#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "Catch.h"

#include <osgWaterReflect/shaders/ShaderSource.h>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/fstream>

#include <cstdlib>
#include <memory>
#include <sstream>
#include <vector>

namespace
{

using Replacements = std::vector<std::unique_ptr<osgWaterReflect::ShaderReplacement>>;

// The files of a directory stand in for the library's shader pieces of their names, so that a
// faulty shader can be tried without a build (tests/mutants).
Replacements replaceShaders()
{
    Replacements replacements;
    const char* const directory = std::getenv("OSGWATERREFLECT_TEST_SHADERS");
    if (!directory) return replacements;
    for (const std::string& name : osgDB::getDirectoryContents(directory))
    {
        if (name.front() == '.') continue;
        osgDB::ifstream file(osgDB::concatPaths(directory, name).c_str());
        std::stringstream text;
        text << file.rdbuf();
        replacements.push_back(
            std::make_unique<osgWaterReflect::ShaderReplacement>(name, text.str()));
    }
    return replacements;
}

} // namespace

int main(int argc, char** argv)
{
    // Tests run side by side: threads of the driver's own (Mesa's llvmpipe) would be in each
    // other's way, and keep memory for as much as ever was in flight at once.
    setenv("LP_NUM_THREADS", "0", 0);
    const Replacements replacements = replaceShaders();
    // Refusals are asked for by many tests; only what no test asked for is worth reading.
    osg::setNotifyLevel(osg::FATAL);
    return Catch::Session().run(argc, argv);
}
