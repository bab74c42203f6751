// What water adds to the cull of a frame on the CPU, by capture, over the same cull without it.
//
// Where a machine does not count instructions, valgrind does, and says in which functions they are:
//     valgrind --tool=callgrind --toggle-collect='osgwaterbench::CullPair::cullWet()'
//         osgwaterbench cpu --frames 2 --only CASE

#include "Experiments.h"

#include "../measures/Percentiles.h"
#include "../scenes/Scenes.h"
#include "CullPair.h"
#include "Progress.h"
#include "Table.h"

#include <iostream>

using namespace osgwaterbench;
using osgWaterReflect::CaptureKind;
using osgWaterReflect::GuardBandKind;
using osgWaterReflect::ReflectionSettings;
using osgWaterReflect::WaveModel;

namespace
{

const glm::ivec2 SIZE(1400, 1050); // [pixels]
const std::size_t DRAWABLES[] = {10, 1000, 10000};
const std::size_t QUICK_DRAWABLES[] = {10, 1000};
const double SLOPE = 0.05;            // of the waves, where there are any
const double FRAME_TIME = 1.0 / 60.0; // [s]

// A cull takes a thousandth of what a frame of the other experiments takes.
const int CULLS_A_FRAME = 8;

// Until then OSG's lists of leaves and matrices to be used again have grown.
const int WARM_UP = 10;

// Drawables of all mirrored images together: more takes long and tells nothing new.
const std::size_t MOST_MIRRORED = 10000;

struct NamedCapture
{
    const char* name;
    CaptureKind kind;
    GuardBandKind band;
};

const NamedCapture CAPTURES[] = {
    {"view", CaptureKind::VIEW, GuardBandKind::NONE},
    {"view, adaptive band", CaptureKind::VIEW, GuardBandKind::ADAPTIVE},
    {"frame", CaptureKind::FRAME, GuardBandKind::NONE},
    {"frame, adaptive band", CaptureKind::FRAME, GuardBandKind::ADAPTIVE},
    {"mirror", CaptureKind::MIRROR, GuardBandKind::NONE},
    {"view and mirror", CaptureKind::VIEW_AND_MIRROR, GuardBandKind::ADAPTIVE},
    {"automatic", CaptureKind::AUTOMATIC, GuardBandKind::ADAPTIVE}};

bool isMirrored(const NamedCapture& capture)
{
    return capture.kind == CaptureKind::MIRROR || capture.kind == CaptureKind::VIEW_AND_MIRROR;
}

struct NamedLayout
{
    const char* name;
    WaterLayout layout;
    std::size_t planes;
};

const NamedLayout LAYOUTS[] = {{"1 water", WaterLayout::ONE, 1},
                               {"64 waters in one plane", WaterLayout::IN_ONE_PLANE, 1},
                               {"64 waters on levels", WaterLayout::ON_LEVELS, 64}};

struct Case
{
    std::size_t drawables;
    BoxStates states;
    NamedLayout layout;
    double slope;
    bool moving; // the eye
    NamedCapture capture;

    std::string scene() const
    {
        return std::to_string(drawables) + " drawables" +
               (states == BoxStates::OWN ? " with own states, " : ", ") + layout.name +
               (slope > 0.0 ? ", waves" : ", calm") + (moving ? ", moving eye" : ", still eye");
    }
    std::string name() const { return scene() + ": " + capture.name; }
};

// Left out is what shows nothing of its own: a still eye makes a difference to waves' meshes alone,
// states to captures alone.
bool isWorthwhile(const Case& tried)
{
    const WaterLayout layout = tried.layout.layout;
    if (!tried.moving && (tried.slope == 0.0 || layout == WaterLayout::ON_LEVELS)) return false;
    if (tried.states == BoxStates::OWN && (!tried.moving || layout != WaterLayout::ONE))
        return false;
    if (tried.capture.kind == CaptureKind::MIRROR && tried.slope > 0.0) return false;
    return !isMirrored(tried.capture) || tried.drawables * tried.layout.planes <= MOST_MIRRORED;
}

std::vector<Case> casesOf(std::size_t drawables, const ExperimentOptions& options)
{
    std::vector<Case> cases;
    const auto add = [&](const Case& tried)
    {
        if (isWorthwhile(tried) && tried.name().find(options.only) != std::string::npos)
            cases.push_back(tried);
    };
    for (const BoxStates states : {BoxStates::SHARED, BoxStates::OWN})
        for (const NamedLayout& layout : LAYOUTS)
            for (const double slope : {0.0, SLOPE})
                for (const bool moving : {false, true})
                    for (const NamedCapture& capture : CAPTURES)
                        add({drawables, states, layout, slope, moving, capture});
    return cases;
}

// Medians over the frames.
struct CullCost
{
    Percentiles microseconds;
    double allocations = 0.0;
    double bytes = 0.0;
    std::optional<double> instructions;
};

CullCost medianOf(const std::vector<ThreadCost>& frames)
{
    std::vector<double> microseconds, allocations, bytes, instructions;
    for (const ThreadCost& frame : frames)
    {
        microseconds.push_back(frame.cpuMicroseconds);
        allocations.push_back(static_cast<double>(frame.allocations.count));
        bytes.push_back(static_cast<double>(frame.allocations.bytes));
        if (frame.instructions) instructions.push_back(*frame.instructions);
    }
    CullCost cost{*percentilesOf(microseconds), percentilesOf(allocations)->median,
                  percentilesOf(bytes)->median, std::nullopt};
    if (const auto counted = percentilesOf(instructions)) cost.instructions = counted->median;
    return cost;
}

struct Compared
{
    CullCost dry;
    CullCost wet;
    double overDry = 0.0; // [1] median of each frame's two times
};

Compared compare(const Case& tried, osg::Group& field, WaveModel* waves, int frames)
{
    const CullPair::Waters waters = createFieldWaters(tried.layout.layout);
    ReflectionSettings settings;
    settings.capture = tried.capture.kind;
    osgWaterReflect::ViewSettings viewSettings;
    viewSettings.guardBand = tried.capture.band;
    for (const auto& water : waters)
    {
        water->setReflection(settings);
        water->setViewSettings(viewSettings);
        water->setWaves(waves);
    }
    CullPair pair(field, waters, SIZE);
    ThreadMeter meter;
    std::vector<ThreadCost> dry, wet;
    std::vector<double> ratios;
    for (int i = -WARM_UP; i < frames; ++i)
    {
        const int frame = i + WARM_UP;
        pair.prepare(fieldEye(tried.moving ? frame : 0), frame * FRAME_TIME);
        pair.cullDry(); // so that it is not the water that has emptied the caches
        meter.start();
        pair.cullDry();
        const ThreadCost dryCost = meter.read();
        meter.start();
        pair.cullWet();
        const ThreadCost wetCost = meter.read();
        if (i < 0) continue;
        dry.push_back(dryCost);
        wet.push_back(wetCost);
        ratios.push_back(wetCost.cpuMicroseconds / dryCost.cpuMicroseconds);
    }
    return {medianOf(dry), medianOf(wet), percentilesOf(ratios)->median};
}

Json jsonOf(const CullCost& cost)
{
    Json json = {{"cpu_us", {{"median", cost.microseconds.median}, {"p90", cost.microseconds.p90}}},
                 {"allocations", cost.allocations},
                 {"allocated_bytes", cost.bytes}};
    if (cost.instructions) json["instructions"] = *cost.instructions;
    return json;
}

Json jsonOf(const Case& tried, const Compared& compared)
{
    Json row = {{"drawables", tried.drawables},
                {"states", tried.states == BoxStates::OWN ? "own" : "shared"},
                {"waters", tried.layout.name},
                {"slope", tried.slope},
                {"eye", tried.moving ? "moving" : "still"},
                {"capture", tried.capture.name},
                {"dry", jsonOf(compared.dry)},
                {"wet", jsonOf(compared.wet)},
                {"cpu_over_dry", compared.overDry}};
    if (compared.dry.instructions && compared.wet.instructions)
        row["instructions_over_dry"] = *compared.wet.instructions / *compared.dry.instructions;
    return row;
}

std::vector<std::string> header(bool withInstructions)
{
    std::vector<std::string> names = {"scene",    "capture",     "dry us",      "wet us",
                                      "over dry", "allocations", "allocated kB"};
    if (withInstructions) names.insert(names.end(), {"dry M instructions", "wet M instructions"});
    return names;
}

std::vector<std::string> printed(const Case& tried, const Compared& compared)
{
    std::vector<std::string> cells = {tried.scene(),
                                      tried.capture.name,
                                      fixed(compared.dry.microseconds.median, 1),
                                      fixed(compared.wet.microseconds.median, 1),
                                      fixed(compared.overDry, 2),
                                      fixed(compared.wet.allocations, 0),
                                      fixed(1e-3 * compared.wet.bytes, 1)};
    for (const CullCost& cost : {compared.dry, compared.wet})
        if (cost.instructions) cells.push_back(fixed(1e-6 * *cost.instructions, 3));
    return cells;
}

} // namespace

bool osgwaterbench::runCpu(const ExperimentOptions& options)
{
    std::vector<Case> cases;
    const auto add = [&](std::size_t drawables)
    {
        const std::vector<Case> of = casesOf(drawables, options);
        cases.insert(cases.end(), of.begin(), of.end());
    };
    if (options.quick)
        for (const std::size_t drawables : QUICK_DRAWABLES)
            add(drawables);
    else
        for (const std::size_t drawables : DRAWABLES)
            add(drawables);
    if (cases.empty())
    {
        std::cerr << "osgwaterbench: --only: expected a part of a case's name, such as \"10 "
                     "drawables, 1 water, calm, moving eye: view\", got "
                  << options.only << std::endl;
        return false;
    }
    const osg::ref_ptr<WaveModel> waves = createWaves("scaling", SLOPE);
    if (!waves) return false;

    const int frames = options.frames * CULLS_A_FRAME;
    ResultFile results(
        "cpu",
        {{"frames", frames}, {"quick", options.quick}, {"width", SIZE.x}, {"height", SIZE.y}});
    const bool withInstructions = InstructionCounter().read().has_value();
    if (!withInstructions)
        std::cout << "without instructions: expected this machine to count them, got no counter\n";
    Table table(header(withInstructions));
    {
        Progress progress("culling", cases.size());
        osg::ref_ptr<osg::Group> field;
        const Case* before = nullptr;
        for (const Case& tried : cases)
        {
            progress.step(tried.name());
            if (!before || before->drawables != tried.drawables || before->states != tried.states)
                field = createBoxField(tried.drawables, tried.states);
            before = &tried;
            const Compared compared =
                compare(tried, *field, tried.slope > 0.0 ? waves.get() : nullptr, frames);
            results.add(jsonOf(tried, compared));
            table.add(printed(tried, compared));
        }
    }
    std::cout << "\n" << table;
    return results.write(options.output);
}
