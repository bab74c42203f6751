// Table 1 of Li and Luo: frames a second at four sizes, of the same view.

#include "Experiments.h"

#include "MethodTimes.h"
#include "Rows.h"
#include "Table.h"

#include <cmath>
#include <iostream>
#include <iterator>

using namespace osgwaterbench;

namespace
{

const glm::ivec2 SIZES[] = {{640, 480}, {800, 600}, {1024, 768}, {1400, 1050}};
const int QUICK_DIVISOR = 4; // of both sides

// What the paper gives, on a GeForce 8800 GTX [frames a second].
const double PAPER_FRAMES[] = {62.5, 31.25, 15.87, 6.41};

const double MOVING_SLOPE = 0.05;

// The exponent of a power law, by least squares of its logarithms.
double exponentOf(const std::vector<double>& pixels, const std::vector<double>& times)
{
    double sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
        const double x = std::log(pixels[i]);
        const double y = std::log(times[i]);
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
    }
    const double count = static_cast<double>(pixels.size());
    return (count * sumXY - sumX * sumY) / (count * sumXX - sumX * sumX);
}

std::vector<Method> searches()
{
    using osgWaterReflect::Search;
    std::vector<Method> methods;
    for (const auto& [name, search] : {std::pair("hierarchical", Search::HIERARCHICAL),
                                       {"sequential", Search::SEQUENTIAL},
                                       {"binary", Search::BINARY}})
    {
        osgWaterReflect::WaterSettings settings = searchOfView();
        settings.search = search;
        methods.push_back(libraryMethod(name, settings));
    }
    methods.push_back(paperMethod());
    methods.push_back(paperBinaryMethod());
    return methods;
}

std::string headerOf(const glm::ivec2& size)
{
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

} // namespace

bool osgwaterbench::runTable1(const ExperimentOptions& options)
{
    ResultFile results("table1",
                       {{"scene", "lake"}, {"frames", options.frames}, {"quick", options.quick}});
    const std::optional<BenchScene> scene = createScene("lake");
    if (!scene) return false;

    std::vector<double> pixels;
    std::vector<double> paperTimes;
    std::vector<std::string> paperRow = {"the paper, GeForce 8800 GTX"};
    for (std::size_t i = 0; i < std::size(SIZES); ++i)
    {
        pixels.push_back(static_cast<double>(SIZES[i].x) * SIZES[i].y);
        paperTimes.push_back(1000.0 / PAPER_FRAMES[i]);
        paperRow.push_back(fixed(PAPER_FRAMES[i], 2));
    }
    paperRow.push_back(fixed(exponentOf(pixels, paperTimes), 2));

    const std::vector<Method> tried = searches();
    for (const double slope : {0.0, MOVING_SLOPE})
    {
        const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves("lake", slope);
        if (slope > 0.0 && !waves) return false;
        std::vector<std::vector<CaseTime>> times; // by size and method
        std::vector<std::string> header = {slope > 0.0 ? "moving water: frames a second"
                                                       : "calm water: frames a second"};
        for (glm::ivec2 size : SIZES)
        {
            if (options.quick) size /= QUICK_DIVISOR;
            header.push_back(headerOf(size));
            times.push_back(timeMethods(*scene, waves, tried, size, options.frames));
            for (std::size_t i = 0; i < tried.size(); ++i)
            {
                Json row = {{"slope", slope}, {"width", size.x}, {"height", size.y}};
                row.update(toJson(tried[i]));
                row.update(toJson(times.back()[i]));
                results.add(row);
            }
        }
        header.push_back("exponent of the frame");
        header.push_back("of the trace");

        Table table(header);
        if (!options.quick) table.add(paperRow);
        for (std::size_t i = 0; i < tried.size(); ++i)
        {
            std::vector<std::string> row = {tried[i].name};
            std::vector<double> frames;
            std::vector<double> traces;
            for (const std::vector<CaseTime>& ofSize : times)
            {
                frames.push_back(ofSize[i].frame.median);
                traces.push_back(ofSize[i].trace.median);
                row.push_back(fixed(1000.0 / frames.back(), 2));
            }
            row.push_back(fixed(exponentOf(pixels, frames), 2));
            row.push_back(fixed(exponentOf(pixels, traces), 2));
            table.add(row);
        }
        std::cout << "\n" << table;
    }
    return results.write(options.output);
}
