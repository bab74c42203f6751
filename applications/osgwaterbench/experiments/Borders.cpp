// What completes reflections at the image's borders and behind what hides them, and what it costs,
// over the plainest search.

#include "Experiments.h"

#include "MethodTimes.h"
#include "Progress.h"
#include "Rows.h"
#include "Table.h"

#include <cmath>
#include <iostream>

using namespace osgwaterbench;
using osgWaterReflect::CaptureKind;
using osgWaterReflect::GuardBandKind;
using osgWaterReflect::Search;
using osgWaterReflect::WaterSettings;

namespace
{

const glm::ivec2 SIZES[] = {{640, 480}, {1400, 1050}};
const int QUICK_DIVISOR = 4; // of both sides

std::vector<Method> methods()
{
    const auto settings = [](CaptureKind capture, GuardBandKind guardBand)
    {
        WaterSettings settings = searchOfView();
        settings.capture = capture;
        settings.guardBand = guardBand;
        return settings;
    };
    const WaterSettings plain = settings(CaptureKind::VIEW, GuardBandKind::NONE);
    WaterSettings sequential = plain;
    sequential.search = Search::SEQUENTIAL;
    return {
        baselineMethod(),
        libraryMethod("sequential", sequential),
        libraryMethod("hierarchical", plain),
        libraryMethod("hierarchical, band 25 %", settings(CaptureKind::VIEW, GuardBandKind::FIXED)),
        libraryMethod("hierarchical, adaptive band",
                      settings(CaptureKind::VIEW, GuardBandKind::ADAPTIVE)),
        libraryMethod("hierarchical, mirror", settings(CaptureKind::MIRROR, GuardBandKind::NONE)),
        libraryMethod("hierarchical, both, band 25 %",
                      settings(CaptureKind::VIEW_AND_MIRROR, GuardBandKind::FIXED)),
        libraryMethod("hierarchical, both, adaptive band",
                      settings(CaptureKind::VIEW_AND_MIRROR, GuardBandKind::ADAPTIVE)),
    };
}

double searchTime(const CaseTime& time)
{
    return time.trace.median + time.pyramid.median;
}

std::vector<std::string> printed(const Method& method, const Measures& measures,
                                 const CaseTime& time, const CaseTime& baseline)
{
    const auto percent = [&measures](TrueClass trueClass, Outcome outcome)
    {
        const std::optional<double> value = measures.of(trueClass).percent(outcome);
        return value ? fixed(*value, 2) : std::string("-");
    };
    const auto& error = measures.hitErrorPixels;
    return {method.name,
            fixed(correctPercent(measures), 2),
            percent(TrueClass::VISIBLE, Outcome::CORRECT),
            percent(TrueClass::HIDDEN, Outcome::CORRECT),
            percent(TrueClass::OUTSIDE_TOP, Outcome::CORRECT),
            percent(TrueClass::OUTSIDE_SIDES, Outcome::CORRECT),
            percent(TrueClass::SKY, Outcome::FALSE_HIT),
            error ? fixed(error->median, 4) : "-",
            fixed(measures.meanFetches.value_or(0.0), 1),
            fixed(time.image.median, 1),
            fixed(time.pyramid.median, 1),
            fixed(time.trace.median, 1),
            fixed(time.frame.median, 1),
            fixed(searchTime(time) / searchTime(baseline), 3)};
}

} // namespace

bool osgwaterbench::runBorders(const ExperimentOptions& options)
{
    ResultFile results("borders", {{"frames", options.frames}, {"quick", options.quick}});
    const std::vector<Method> tried = methods();
    for (const char* name : {"boxes", "boxes-branch"})
        for (const double slope : options.quick ? std::vector{0.05} : std::vector{0.0, 0.05, 0.15})
            for (glm::ivec2 size : SIZES)
            {
                if (options.quick) size /= QUICK_DIVISOR;
                const std::optional<BenchScene> scene = createScene(name);
                if (!scene) return false;
                const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves(name, slope);
                if (slope > 0.0 && !waves) return false;

                Measurement measurement(*scene, waves, size);
                std::vector<Measures> measured;
                {
                    Progress progress(std::string("measuring ") + name, tried.size());
                    for (const Method& method : tried)
                    {
                        progress.step(method.name);
                        measured.push_back(measurement.measurePlaces(method));
                    }
                }
                const std::vector<CaseTime> times =
                    timeMethods(*scene, waves, tried, size, options.frames);

                std::cout << "\n"
                          << name << ", slope " << slope << ", " << size.x << "x" << size.y << ", "
                          << measurement.waterPixels() << " water pixels\n";
                Table table({"method", "right %", "visible right %", "hidden right %",
                             "top right %", "sides right %", "sky false %", "median px", "fetches",
                             "image ms", "pyramid ms", "trace ms", "frame ms",
                             "pyramid + trace, baseline 1"});
                for (std::size_t i = 0; i < tried.size(); ++i)
                {
                    Json row = {
                        {"scene", name}, {"slope", slope}, {"width", size.x}, {"height", size.y}};
                    row.update(toJson(tried[i]));
                    row.update(toJson(measured[i]));
                    row.update(toJson(times[i]));
                    results.add(row);
                    table.add(printed(tried[i], measured[i], times[i], times.front()));
                }
                std::cout << table;
            }
    return results.write(options.output);
}
