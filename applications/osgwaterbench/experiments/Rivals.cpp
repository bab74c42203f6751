// The techniques that reflections on moving water are usually made with, beside tracing.

#include "Experiments.h"

#include "MethodTimes.h"
#include "PictureSheet.h"
#include "Progress.h"
#include "Rows.h"
#include "Table.h"

#include <iostream>

using namespace osgwaterbench;
using osgWaterReflect::WaterSettings;

namespace
{

// How strongly the mirrored image may be bent: from not at all to what is right for things
// infinitely far away, and beyond.
const double DISTORTIONS[] = {0.0, 0.1, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5, 2.5};
// [m] The same at this distance from the eye, where it varies with it.
const double DISTORTION_DISTANCE = 10.0;

// The slope of the waves in the pictures.
const double PICTURED_SLOPE = 0.05;

// The mirrored camera's best setting here: with the most pixels right, and of equal ones that which
// bends least.
Method bestMirror(Measurement& measurement)
{
    Progress progress("finding the mirrored camera's best setting", 2 * std::size(DISTORTIONS));
    Method best = mirrorMethod({0.0, false});
    double bestPercent = -1.0;
    for (const bool overDistance : {false, true})
        for (const double distortion : DISTORTIONS)
        {
            progress.step(fixed(distortion, 3));
            const Method method = mirrorMethod(
                {overDistance ? distortion * DISTORTION_DISTANCE : distortion, overDistance});
            const double percent = correctPercent(measurement.measurePlaces(method));
            if (percent <= bestPercent) continue;
            bestPercent = percent;
            best = method;
        }
    return best;
}

bool writePictures(Measurement& measurement, const Method& own, const Method& mirror,
                   const std::string& file)
{
    const Picture truth = measurement.truePicture();
    const auto& isWater = measurement.isWater();
    const Picture traced = measurement.picture(own);
    const Picture paper = measurement.picture(paperMethod());
    const Picture mirrored = measurement.picture(mirror);
    const Picture sky = measurement.picture(skyOnlyMethod());
    return writeSheet(file,
                      {{truth, traced, paper, mirrored},
                       {sky, errorMap(traced, truth, isWater), errorMap(paper, truth, isWater),
                        errorMap(mirrored, truth, isWater)}});
}

std::vector<std::string> printed(const Method& method, const Accuracy& accuracy,
                                 const CaseTime& time)
{
    std::vector<std::string> row = {method.name, fixed(correctPercent(accuracy.measures), 2)};
    for (int i = 0; i < TRUE_CLASS_COUNT; ++i)
    {
        const std::optional<double> percent =
            accuracy.measures.classes[i].percent(Outcome::CORRECT);
        row.push_back(percent ? fixed(*percent, 2) : "-");
    }
    const auto& error = accuracy.measures.hitErrorPixels;
    row.push_back(error ? fixed(error->median, 2) : "-");
    row.push_back(accuracy.picture.psnr ? fixed(*accuracy.picture.psnr, 1) : "-");
    row.push_back(fixed(accuracy.picture.ssim, 4));
    row.push_back(fixed(time.trace.median, 1));
    row.push_back(fixed(time.frame.median, 1));
    return row;
}

} // namespace

bool osgwaterbench::runRivals(const ExperimentOptions& options)
{
    ResultFile results("rivals", commonConditions(options));
    for (const std::string& name : options.scenes)
        for (const double slope : slopes(options))
        {
            const std::optional<BenchScene> scene = createScene(name);
            if (!scene) return false;
            const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves(name, slope);
            if (slope > 0.0 && !waves) return false;

            Measurement measurement(*scene, waves, options.size);
            const Method own = libraryMethod("automatic", WaterSettings());
            const Method mirror = bestMirror(measurement);
            const std::vector<Method> rivals = {own, paperMethod(), paperBinaryMethod(), mirror,
                                                skyOnlyMethod()};
            const std::vector<CaseTime> times =
                timeMethods(*scene, waves, rivals, options.size, options.frames);

            std::cout << "\n"
                      << name << ", slope " << slope << ", " << measurement.waterPixels()
                      << " water pixels\n";
            Table table({"method", "right %", "sky right %", "visible right %", "hidden right %",
                         "top right %", "sides right %", "median px", "PSNR dB", "SSIM", "trace ms",
                         "frame ms"});
            for (std::size_t i = 0; i < rivals.size(); ++i)
            {
                const Accuracy accuracy = measurement.measure(rivals[i]);
                Json row = {{"scene", name}, {"slope", slope}};
                row.update(toJson(rivals[i]));
                row.update(toJson(accuracy));
                row.update(toJson(times[i]));
                results.add(row);
                table.add(printed(rivals[i], accuracy, times[i]));
            }
            std::cout << table;
            if (slope == PICTURED_SLOPE &&
                !writePictures(measurement, own, mirror,
                               options.output + "/rivals-" + name + ".jpg"))
                return false;
        }
    return results.write(options.output);
}
