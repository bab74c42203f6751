#include "experiments/Experiments.h"

#include "scenes/Scenes.h"

#include <osg/ApplicationUsage>
#include <osg/ArgumentParser>

#include <algorithm>
#include <iostream>
#include <sstream>

using namespace osgwaterbench;

namespace
{

const glm::ivec2 QUICK_SIZE(240, 180);
const int LARGEST_SIDE = 8192; // [pixels]

int complain(const std::string& message)
{
    std::cerr << "osgwaterbench: " << message << std::endl;
    return 1;
}

void showUsage()
{
    std::cout << "usage: osgwaterbench EXPERIMENT... [options]\n\n"
                 "Measures what accuracy costs in time: prints tables, and writes\n"
                 "EXPERIMENT.json (and pictures) to a directory.\n\nexperiments:\n";
    for (const Experiment& experiment : EXPERIMENTS)
        std::cout << "  " << experiment.name
                  << std::string(12 - std::string(experiment.name).size(), ' ')
                  << experiment.purpose << "\n";
    std::cout << "\noptions:\n"
                 "  --quick           each experiment in under a minute on two cores: a smaller\n"
                 "                    picture, fewer settings, 5 frames\n"
                 "  --output DIR      where results go (default: the current directory)\n"
                 "  --scenes A,B      of accuracy and rivals (default: all); they are\n"
                 "                   ";
    for (const std::string& name : sceneNames())
        std::cout << " " << name;
    std::cout
        << "\n"
           "  --only TEXT       of cpu: the cases in whose names it occurs (default: all)\n"
           "  --size WxH        picture of accuracy, rivals and scaling (default: 640x480)\n"
           "  --frames N        timed at each point, 2 or more (default: 5); cpu: 8 times as many\n"
           "  --help            this text\n";
}

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

// False where a text is anything else than WxH.
bool parseSize(const std::string& text, glm::ivec2& size)
{
    std::istringstream stream(text);
    char x = 0;
    return stream >> size.x >> x >> size.y && x == 'x' && stream.peek() == EOF && size.x >= 1 &&
           size.y >= 1 && std::max(size.x, size.y) <= LARGEST_SIDE;
}

const Experiment* findExperiment(const std::string& name)
{
    for (const Experiment& experiment : EXPERIMENTS)
        if (name == experiment.name) return &experiment;
    return nullptr;
}

// What is wrong with the options; empty where nothing is.
std::string parse(osg::ArgumentParser& arguments, ExperimentOptions& options,
                  std::vector<const Experiment*>& experiments)
{
    options.quick = arguments.read("--quick");
    if (options.quick) options.size = QUICK_SIZE;
    arguments.read("--output", options.output);
    std::string text;
    options.scenes = sceneNames();
    if (arguments.read("--scenes", text))
    {
        const std::vector<std::string> known = options.scenes;
        options.scenes = splitAtCommas(text);
        for (const std::string& name : options.scenes)
            if (std::find(known.begin(), known.end(), name) == known.end())
                return "--scenes: expected names of scenes (--help has them), got " + name;
    }
    arguments.read("--only", options.only);
    if (arguments.read("--size", text) && !parseSize(text, options.size))
        return "--size: expected WxH of 1 to 8192 pixels, got " + text;
    if (arguments.read("--frames", text))
    {
        std::istringstream stream(text);
        if (!(stream >> options.frames) || stream.peek() != EOF || options.frames < 2)
            return "--frames: expected a whole number of at least 2, got " + text;
    }
    arguments.reportRemainingOptionsAsUnrecognized();
    if (arguments.errors()) return arguments.getErrorMessageMap().begin()->first;

    for (int i = 1; i < arguments.argc(); ++i)
    {
        const Experiment* const experiment = findExperiment(arguments[i]);
        if (!experiment)
            return std::string("expected an experiment (--help has them), got ") + arguments[i];
        experiments.push_back(experiment);
    }
    return experiments.empty() ? "expected an experiment (--help has them), got none" : "";
}

} // namespace

int main(int argc, char** argv)
{
    osg::ArgumentParser arguments(&argc, argv);
    if (arguments.read("--help") || arguments.read("-h"))
    {
        showUsage();
        return 0;
    }
    ExperimentOptions options;
    std::vector<const Experiment*> experiments;
    const std::string wrong = parse(arguments, options, experiments);
    if (!wrong.empty()) return complain(wrong);

    try
    {
        for (const Experiment* experiment : experiments)
            if (!experiment->run(options)) return 1;
    }
    catch (const std::exception& error)
    {
        return complain(error.what());
    }
    return 0;
}
