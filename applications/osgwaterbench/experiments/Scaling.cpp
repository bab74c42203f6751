// What the time of the trace, and of the whole frame, depends on.

#include "Experiments.h"

#include "../render/BenchView.h"
#include "Rows.h"
#include "Table.h"
#include "Timing.h"

#include <iostream>
#include <memory>

using namespace osgwaterbench;

namespace
{

// One point of a curve: a view of its own, and what is varied.
struct Point
{
    std::string varied; // triangles, waters, corners or pixels
    double value = 0.0;
    double slope = 0.0; // of the waves
    bool water = true;
    std::unique_ptr<BenchView> view;
};

// Moving water; where waves may make a difference to what is varied, calm water, too.
const double SLOPE = 0.05;
const double CALM = 0.0;

// Of the experiments in which something else is varied.
const std::size_t TRIANGLES = 100000;

const int QUICK_DIVISOR = 4; // of both sides of the sizes

// Only what is varied makes a difference between points: waters move as the scene's own would.
class Points
{
public:
    explicit Points(const ExperimentOptions& options) : _options(options) {}

    bool addScenes()
    {
        for (std::size_t triangles = 1000; triangles <= (_options.quick ? 1000000u : 10000000u);
             triangles *= 10)
            for (const bool water : {true, false})
                if (!add("triangles", static_cast<double>(triangles), SLOPE, triangles,
                         _options.size,
                         [water](const BenchScene& scene)
                         { return water ? BenchView::Waters{scene.water} : BenchView::Waters(); }))
                    return false;
        return true;
    }

    bool addWaters()
    {
        for (const double slope : {CALM, SLOPE})
            for (const int count : {1, 4, 16, 64})
                if (!add("waters", count, slope, TRIANGLES, _options.size,
                         [count](const BenchScene&) { return createWaters(count); }))
                    return false;
        return true;
    }

    bool addOutlines()
    {
        for (const double slope : {CALM, SLOPE})
            for (const int corners : {4, 64, 1024})
                if (!add("corners", corners, slope, TRIANGLES, _options.size,
                         [corners](const BenchScene&)
                         { return BenchView::Waters{createShapedWater(corners)}; }))
                    return false;
        return true;
    }

    bool addSizes()
    {
        for (glm::ivec2 size : {glm::ivec2(320, 240), {640, 480}, {1024, 768}, {1400, 1050}})
        {
            if (_options.quick) size /= QUICK_DIVISOR;
            if (!add("pixels", static_cast<double>(size.x) * size.y, SLOPE, TRIANGLES, size,
                     [](const BenchScene& scene) { return BenchView::Waters{scene.water}; }))
                return false;
        }
        return true;
    }

    const std::vector<Point>& all() const { return _points; }

private:
    template <class ChooseWaters>
    bool add(const std::string& varied, double value, double slope, std::size_t triangles,
             const glm::ivec2& size, const ChooseWaters& choose)
    {
        const BenchScene scene = createScalingScene(triangles);
        if (!scene.scene) return false;
        const BenchView::Waters waters = choose(scene);
        const osg::ref_ptr<osgWaterReflect::WaveModel> waves = createWaves(scene.name, slope);
        for (const auto& water : waters)
        {
            if (!water) return false;
            water->setWaves(waves);
        }
        Point point{varied, value, slope, !waters.empty(),
                    std::make_unique<BenchView>(scene, size, BenchView::Purpose::TIME)};
        point.view->setWaters(waters);
        _points.push_back(std::move(point));
        return true;
    }

    const ExperimentOptions& _options;
    std::vector<Point> _points;
};

} // namespace

bool osgwaterbench::runScaling(const ExperimentOptions& options)
{
    Json conditions = commonConditions(options);
    conditions["triangles"] = TRIANGLES;
    ResultFile results("scaling", conditions);

    Points points(options);
    if (!points.addScenes() || !points.addWaters() || !points.addOutlines() || !points.addSizes())
        return false;
    std::vector<TimedCase> cases;
    for (const Point& point : points.all())
        cases.push_back({point.varied + " " + fixed(point.value, 0), [] {},
                         [&point] { return point.view->time(); }});
    const std::vector<CaseTime> times = timeSideBySide(cases, options.frames);

    Table table({"varied", "value", "slope", "water", "capture ms", "trace ms", "frame ms"});
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        const Point& point = points.all()[i];
        Json row = {{"varied", point.varied},
                    {"value", point.value},
                    {"slope", point.slope},
                    {"water", point.water}};
        row.update(toJson(times[i]));
        results.add(row);
        table.add({point.varied, fixed(point.value, 0), fixed(point.slope, 2),
                   point.water ? "yes" : "no", fixed(times[i].image.median, 1),
                   fixed(times[i].trace.median, 1), fixed(times[i].frame.median, 1)});
    }
    std::cout << "\n" << table;
    return results.write(options.output);
}
