// What each search and setting costs, and how right it is.

#include "Experiments.h"

#include "MethodTimes.h"
#include "Progress.h"
#include "Rows.h"
#include "Table.h"

#include <iostream>

using namespace osgwaterbench;
using osgWaterReflect::CaptureKind;
using osgWaterReflect::Search;
using osgWaterReflect::WaterSettings;

namespace
{

// A search of the view's capture with one setting changed, which the name tells.
class Settings
{
public:
    Settings(const std::string& name, Search search) : _name(name), _settings(searchOfView())
    {
        _settings.search = search;
    }

    Method method() const { return libraryMethod(_name, _settings); }
    Method withThickness(double thickness) const
    {
        WaterSettings settings = _settings;
        settings.thickness = thickness;
        return libraryMethod(_name + ", thickness " + fixed(thickness, 1), settings);
    }
    Method withCaptureScale(double scale) const
    {
        WaterSettings settings = _settings;
        settings.captureScale = scale;
        return libraryMethod(_name + ", capture scale " + fixed(scale, 2), settings);
    }
    Method withCapture(const std::string& name, CaptureKind capture) const
    {
        WaterSettings settings = _settings;
        settings.capture = capture;
        return libraryMethod(_name + ", " + name, settings);
    }
    Method withTraceScale(double scale) const
    {
        WaterSettings settings = _settings;
        settings.traceScale = scale;
        return libraryMethod(_name + ", trace scale " + fixed(scale, 2), settings);
    }
    Method withStride(int stride) const
    {
        WaterSettings settings = _settings;
        settings.stride = stride;
        return libraryMethod(_name + ", stride " + std::to_string(stride), settings);
    }

private:
    std::string _name;
    WaterSettings _settings;
};

std::vector<Method> methods(bool quick)
{
    const Method automatic = libraryMethod("automatic", WaterSettings());
    const Settings hierarchical("hierarchical", Search::HIERARCHICAL);
    const Settings sequential("sequential", Search::SEQUENTIAL);
    const Settings binary("binary", Search::BINARY);
    const Method mirror = hierarchical.withCapture("mirror", CaptureKind::MIRROR);
    const Method both = hierarchical.withCapture("both", CaptureKind::VIEW_AND_MIRROR);
    if (quick)
        return {automatic,
                hierarchical.method(),
                mirror,
                both,
                hierarchical.withCaptureScale(0.5),
                hierarchical.withTraceScale(0.5),
                sequential.method(),
                sequential.withStride(4),
                binary.method(),
                paperMethod(),
                paperBinaryMethod(),
                baselineMethod()};
    return {automatic,
            hierarchical.method(),
            mirror,
            both,
            hierarchical.withThickness(0.1),
            hierarchical.withThickness(2.0),
            hierarchical.withCaptureScale(0.5),
            hierarchical.withCaptureScale(0.25),
            hierarchical.withTraceScale(0.5),
            hierarchical.withTraceScale(0.25),
            sequential.method(),
            sequential.withStride(2),
            sequential.withStride(4),
            sequential.withStride(8),
            binary.method(),
            paperMethod(),
            paperBinaryMethod(),
            baselineMethod()};
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
