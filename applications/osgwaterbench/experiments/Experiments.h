#ifndef OSGWATERBENCH_EXPERIMENTS_H
#define OSGWATERBENCH_EXPERIMENTS_H

#include "ResultFile.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace osgwaterbench
{

/// What every experiment is told.
struct ExperimentOptions
{
    bool quick = false;              ///< each in under a minute on two cores
    int frames = 5;                  ///< that are timed at each point, >= 2
    glm::ivec2 size{640, 480};       ///< [pixels] of accuracy, rivals and scaling
    std::vector<std::string> scenes; ///< of accuracy and rivals
    std::string only;                ///< of cpu: the cases in whose names it occurs
    std::string output = ".";        ///< a directory for EXPERIMENT.json and pictures
};

/// An experiment prints a table and writes its results. False, with a message, where it cannot.
struct Experiment
{
    const char* name;
    const char* purpose;
    bool (*run)(const ExperimentOptions& options);
};

/// What holds for all rows of accuracy and rivals.
Json commonConditions(const ExperimentOptions& options);

/// The slopes of the waves that scenes are measured with; 0 is calm (createWaves()).
std::vector<double> slopes(const ExperimentOptions& options);

bool runTable1(const ExperimentOptions& options);
bool runAccuracy(const ExperimentOptions& options);
bool runRivals(const ExperimentOptions& options);
bool runScaling(const ExperimentOptions& options);
bool runBorders(const ExperimentOptions& options);
bool runAdded(const ExperimentOptions& options);
bool runCpu(const ExperimentOptions& options);

inline const Experiment EXPERIMENTS[] = {
    {"table1", "frames a second at the paper's four sizes, by search", runTable1},
    {"accuracy", "every search and setting: what it costs and how right it is", runAccuracy},
    {"rivals", "a sky cube map only, a mirrored camera, the paper's method, and ours", runRivals},
    {"scaling", "time against triangles, waters, outlines and pixels", runScaling},
    {"borders", "captures and guard bands against the plainest search, at two sizes", runBorders},
    {"added", "what water adds to a frame, by capture, over a mirrored camera", runAdded},
    {"cpu", "what water adds to a frame's cull on the CPU, by capture", runCpu},
};

} // namespace osgwaterbench

#endif
