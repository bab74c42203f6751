// What water adds to the time of a frame, by capture, over what a mirrored camera adds.

#include "Experiments.h"

#include "../render/BenchView.h"
#include "Rows.h"
#include "Table.h"
#include "Timing.h"

#include <deque>
#include <iostream>
#include <optional>

using namespace osgwaterbench;
using osgWaterReflect::CaptureKind;
using osgWaterReflect::GuardBandKind;
using osgWaterReflect::WaterSettings;

namespace
{

const glm::ivec2 SIZE(1400, 1050);
const int QUICK_DIVISOR = 4; // of both sides
const std::size_t TRIANGLES[] = {3000, 100000, 1000000, 10000000};
const std::size_t QUICK_TRIANGLES[] = {3000, 1000000};
const double SLOPES[] = {0.0, 0.05};

const MirrorLook LOOK = {0.05, true};

std::vector<Method> methods()
{
    const auto library = [](const std::string& name, CaptureKind capture, GuardBandKind band)
    {
        WaterSettings settings = searchOfView();
        settings.capture = capture;
        settings.guardBand = band;
        return libraryMethod(name, settings);
    };
    return {mirrorMethod(LOOK),
            library("view", CaptureKind::VIEW, GuardBandKind::NONE),
            library("view, adaptive band", CaptureKind::VIEW, GuardBandKind::ADAPTIVE),
            library("frame", CaptureKind::FRAME, GuardBandKind::NONE),
            library("frame, adaptive band", CaptureKind::FRAME, GuardBandKind::ADAPTIVE),
            library("mirrored capture", CaptureKind::MIRROR, GuardBandKind::NONE)};
}

// One scene with each kind of waves, and without water.
struct Place
{
    double triangles = 0.0;
    double slope = 0.0;
    std::optional<Method> method; // none: no water
    BenchView* view = nullptr;
};

class Places
{
public:
    bool add(std::size_t triangles, const glm::ivec2& size)
    {
        if (!addView(triangles, 0.0, size, false)) return false;
        for (const double slope : SLOPES)
            if (!addView(triangles, slope, size, true)) return false;
        return true;
    }
    const std::vector<Place>& all() const { return _places; }

    /// The one without water in the same scene.
    std::size_t withoutWater(const Place& place) const
    {
        std::size_t i = 0;
        while (_places[i].method || _places[i].triangles != place.triangles)
            ++i;
        return i;
    }

    /// The one with a mirrored camera in the same scene, on the same waves.
    std::size_t mirrored(const Place& place) const
    {
        std::size_t i = 0;
        while (!_places[i].method || !_places[i].method->mirror ||
               _places[i].triangles != place.triangles || _places[i].slope != place.slope)
            ++i;
        return i;
    }

private:
    bool addView(std::size_t triangles, double slope, const glm::ivec2& size, bool water)
    {
        const BenchScene scene = createScalingScene(triangles);
        if (!scene.scene) return false;
        _views.emplace_back(scene, size, BenchView::Purpose::TIME);
        BenchView& view = _views.back();
        view.setWaves(createWaves(scene.name, slope));
        Place place{static_cast<double>(triangles), slope, {}, &view};
        if (!water)
        {
            view.setWaters({});
            _places.push_back(place);
            return true;
        }
        for (const Method& method : methods())
        {
            place.method = method;
            _places.push_back(place);
        }
        return true;
    }

    std::deque<BenchView> _views;
    std::vector<Place> _places;
};

} // namespace

bool osgwaterbench::runAdded(const ExperimentOptions& options)
{
    const glm::ivec2 size = options.quick ? SIZE / QUICK_DIVISOR : SIZE;
    ResultFile results("added", {{"frames", options.frames},
                                 {"quick", options.quick},
                                 {"width", size.x},
                                 {"height", size.y}});
    Places places;
    if (options.quick)
    {
        for (const std::size_t triangles : QUICK_TRIANGLES)
            if (!places.add(triangles, size)) return false;
    }
    else
        for (const std::size_t triangles : TRIANGLES)
            if (!places.add(triangles, size)) return false;

    std::vector<TimedCase> cases;
    for (const Place& place : places.all())
        cases.push_back({fixed(place.triangles, 0) + " triangles",
                         [&place]
                         {
                             if (place.method) place.view->setMethod(*place.method);
                         },
                         [&place] { return place.view->time(); }});
    const std::vector<CaseTime> times = timeSideBySide(cases, options.frames);

    Table table({"triangles", "slope", "method", "image ms", "pyramid ms", "trace ms", "frame ms",
                 "over no water", "added, mirrored camera 1"});
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        const Place& place = places.all()[i];
        const double dry = times[places.withoutWater(place)].frame.median;
        Json row = {{"triangles", place.triangles}, {"slope", place.slope}};
        row["method"] = place.method ? Json(place.method->name) : Json();
        row.update(toJson(times[i]));
        std::string over = "-";
        std::string added = "-";
        if (place.method)
        {
            const double mirrored = times[places.mirrored(place)].frame.median;
            row["over_no_water"] = times[i].frame.median / dry;
            row["added_over_mirrored_camera"] = (times[i].frame.median - dry) / (mirrored - dry);
            over = fixed(times[i].frame.median / dry, 3);
            added = fixed((times[i].frame.median - dry) / (mirrored - dry), 3);
        }
        results.add(row);
        table.add({fixed(place.triangles, 0), fixed(place.slope, 2),
                   place.method ? place.method->name : "no water", fixed(times[i].image.median, 1),
                   fixed(times[i].pyramid.median, 1), fixed(times[i].trace.median, 1),
                   fixed(times[i].frame.median, 1), over, added});
    }
    std::cout << "\n" << table;
    return results.write(options.output);
}
