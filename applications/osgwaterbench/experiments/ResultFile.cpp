#include "ResultFile.h"

#include "../render/StageClock.h"

#include <osgDB/FileUtils>

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

using namespace osgwaterbench;

namespace
{

std::string nameOfProcessor()
{
    std::ifstream info("/proc/cpuinfo");
    const std::string key = "model name";
    for (std::string line; std::getline(info, line);)
        if (line.compare(0, key.size(), key) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

// The last commit of the source tree, marked where files differ from it.
std::string describeCommit()
{
    const char* const command = "git -C \"" OSGWATERREFLECT_SOURCE_DIRECTORY
                                "\" describe --always --dirty --abbrev=12 2>/dev/null";
    const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command, "r"), pclose);
    char text[64] = "";
    if (!output || !std::fgets(text, sizeof text, output.get())) return "unknown";
    const std::string commit = text;
    return commit.substr(0, commit.find('\n'));
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    char text[16] = "";
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

const char* textOf(GLenum name)
{
    return reinterpret_cast<const char*>(glGetString(name));
}

} // namespace

Json osgwaterbench::describeMachine()
{
    const osg::ref_ptr<osg::GraphicsContext> context =
        osgWaterReflect::createOffscreenContext(1, 1);
    if (!context || !context->realize() || !context->makeCurrent())
        throw std::runtime_error("expected an offscreen graphics context, got none");
    Json machine;
    machine["processor"] = nameOfProcessor();
    machine["cores"] = std::thread::hardware_concurrency();
    machine["renderer"] = textOf(GL_RENDERER);
    machine["driver"] = textOf(GL_VERSION);
    machine["clock"] = StageClock::wayOfCurrentContext() == StageClock::Way::FINISH
                           ? "glFinish around each stage"
                           : "GL_TIMESTAMP queries";
    context->releaseContext();
    return machine;
}

ResultFile::ResultFile(const std::string& experiment, const Json& conditions) :
    _experiment(experiment)
{
    _content["experiment"] = experiment;
    _content["date"] = today();
    _content["commit"] = describeCommit();
    _content["machine"] = describeMachine();
    _content["conditions"] = conditions;
    _content["rows"] = Json::array();
}

bool ResultFile::write(const std::string& directory) const
{
    const std::string file = directory + "/" + _experiment + ".json";
    osgDB::makeDirectory(directory);
    std::ofstream stream(file);
    stream << _content.dump(1) << "\n";
    stream.close();
    if (!stream)
    {
        std::cerr << "osgwaterbench: " << file << ": expected a file to be written, got none\n";
        return false;
    }
    std::cout << "written: " << file << std::endl;
    return true;
}
