#include "Experiments.h"

using namespace osgwaterbench;

Json osgwaterbench::commonConditions(const ExperimentOptions& options)
{
    return {{"width", options.size.x},
            {"height", options.size.y},
            {"frames", options.frames},
            {"quick", options.quick}};
}

std::vector<double> osgwaterbench::slopes(const ExperimentOptions& options)
{
    if (options.quick) return {0.05};
    return {0.0, 0.05, 0.1, 0.15};
}
