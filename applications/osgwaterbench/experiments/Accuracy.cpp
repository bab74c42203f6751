// What each search and setting costs, and how right it is.

#include "Experiments.h"

#include "MethodTimes.h"
#include "Progress.h"
#include "Rows.h"
#include "Table.h"

#include <iostream>

using namespace osgwaterbench;
using osgWaterReflect::ReflectionSettings;
using osgWaterReflect::Search;

namespace
{

Method own(const std::string& name, const ReflectionSettings& settings)
{
    return libraryMethod(name, settings);
}

std::vector<Method> methods(bool quick)
{
    std::vector<Method> result;
    ReflectionSettings settings;
    result.push_back(own("sequential", settings));
    for (const int stride : quick ? std::vector<int>{4} : std::vector<int>{2, 4, 8})
    {
        ReflectionSettings strided = settings;
        strided.stride = stride;
        result.push_back(own("sequential, stride " + std::to_string(stride), strided));
    }
    for (const double thickness : quick ? std::vector<double>{} : std::vector<double>{0.1, 2.0})
    {
        ReflectionSettings thick = settings;
        thick.thickness = thickness;
        result.push_back(own("sequential, thickness " + fixed(thickness, 1), thick));
    }
    for (const double scale : quick ? std::vector<double>{0.5} : std::vector<double>{0.5, 0.25})
    {
        ReflectionSettings scaled = settings;
        scaled.captureScale = scale;
        result.push_back(own("sequential, capture scale " + fixed(scale, 2), scaled));
    }
    settings.search = Search::BINARY;
    result.push_back(own("binary", settings));
    result.push_back(paperMethod());
    result.push_back(paperBinaryMethod());
    result.push_back(baselineMethod());
    return result;
}

std::vector<std::string> printed(const Method& method, const Accuracy& accuracy,
                                 const CaseTime& time)
{
    const Measures& measures = accuracy.measures;
    const auto percent = [&measures](TrueClass trueClass, Outcome outcome)
    {
        const std::optional<double> value = measures.of(trueClass).percent(outcome);
        return value ? fixed(*value, 2) : std::string("-");
    };
    const auto& error = measures.hitErrorPixels;
    return {method.name,
            fixed(correctPercent(measures), 2),
            percent(TrueClass::VISIBLE, Outcome::CORRECT),
            percent(TrueClass::SKY, Outcome::FALSE_HIT),
            error ? fixed(error->median, 3) : "-",
            error ? fixed(error->p99, 1) : "-",
            accuracy.picture.psnr ? fixed(*accuracy.picture.psnr, 1) : "-",
            fixed(accuracy.picture.ssim, 4),
            fixed(measures.meanFetches.value_or(0.0), 1),
            fixed(time.trace.median, 1),
            fixed(time.image.median, 1)};
}

} // namespace

bool osgwaterbench::runAccuracy(const ExperimentOptions& options)
{
    ResultFile results("accuracy", commonConditions(options));
    const std::vector<Method> tried = methods(options.quick);
    for (const std::string& name : options.scenes)
        for (const double slope : slopes(options))
        {
            const std::optional<BenchScene> scene = createScene(name);
            if (!scene) return false;
            const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves(name, slope);
            if (slope > 0.0 && !waves) return false;

            Measurement measurement(*scene, waves, options.size);
            std::vector<Accuracy> accuracies;
            {
                Progress progress("measuring " + name, tried.size());
                for (const Method& method : tried)
                {
                    progress.step(method.name);
                    accuracies.push_back(measurement.measure(method));
                }
            }
            const std::vector<CaseTime> times =
                timeMethods(*scene, waves, tried, options.size, options.frames);

            std::cout << "\n"
                      << name << ", slope " << slope << ", " << measurement.waterPixels()
                      << " water pixels\n";
            Table table({"method", "right %", "visible right %", "sky false %", "median px",
                         "p99 px", "PSNR dB", "SSIM", "fetches", "trace ms", "image ms"});
            const Json tessellation = toJson(measurement.tessellation());
            for (std::size_t i = 0; i < tried.size(); ++i)
            {
                Json row = {{"scene", name}, {"slope", slope}};
                row.update(toJson(tried[i]));
                row.update(toJson(accuracies[i]));
                row["tessellation"] = tessellation;
                row.update(toJson(times[i]));
                results.add(row);
                table.add(printed(tried[i], accuracies[i], times[i]));
            }
            std::cout << table;
        }
    return results.write(options.output);
}
