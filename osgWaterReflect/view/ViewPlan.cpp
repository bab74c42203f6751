#include "ViewPlan.h"

#include "../band/ReflectedExtent.h"
#include "AccuracySteps.h"
#include "PlanReasons.h"

#include "../Transforms.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace osgWaterReflect;

namespace
{

// Slopes up to this times their root mean square are those of all but the steepest places: of a
// sum of many waves' places 98 %.
const double MOST_SLOPES = 2.0;

class Planner
{
public:
    Planner(const ViewFacts& facts, ViewPlan& plan) : _facts(facts), _plan(plan) {}

    void run()
    {
        settleSheets();
        saveTime();
        planEffects();
        planEyeImage();
        planMirrors();
        planTrace();
        planSky();
        explain(_facts, _plan);
    }

private:
    WaterSettings asked(std::size_t i) const { return settingsAskedFor(*_facts.sheets[i].water); }

    bool isAutomatic(std::size_t i) const
    {
        return _facts.sheets[i].water->getReflection().capture == CaptureKind::AUTOMATIC;
    }

    CaptureEye mirrorOf(std::size_t i) const
    {
        const VisibleSheet& visible = _facts.sheets[i];
        return mirroredEye(visible.eyeFromSurface, _facts.clipFromEye, visible.eyeAbove);
    }

    // What is automatic, by the sheets that leave it to the view.
    void settleSheets()
    {
        SceneFacts& scene = _plan.scene = SceneFacts();
        scene.redrawsAlike = _facts.redrawsAlike;
        scene.bandServes = false; // not known yet
        CaptureEye plane;
        scene.planes = 0;
        for (std::size_t i = 0; i < _facts.sheets.size(); ++i)
        {
            if (!isAutomatic(i)) continue;
            scene.calm = scene.calm && _facts.sheets[i].bounds->calm();
            if (scene.planes > 1) continue; // how many more does not matter
            const CaptureEye eye = mirrorOf(i);
            if (scene.planes == 0 || !serveTogether(plane, eye)) ++scene.planes;
            plane = eye;
        }
        _plan.sheets.resize(_facts.sheets.size());
        for (std::size_t i = 0; i < _facts.sheets.size(); ++i)
        {
            _plan.sheets[i].settings = settle(asked(i), scene);
            _plan.sheets[i].mirror = -1;
        }
        _settled.clear();
    }

    // What frames have no time for.
    void saveTime()
    {
        double target = 0.0; // [ms]
        std::size_t numSteps = 1;
        for (const ViewPlan::Sheet& sheet : _plan.sheets)
        {
            const double own = sheet.settings.frameTimeTarget;
            if (own == 0.0) continue;
            target = target == 0.0 ? own : std::min(target, own);
            numSteps = std::max(numSteps, accuracySteps(sheet.settings).size());
        }
        _plan.accuracyStep = 0;
        if (target == 0.0) return;
        _plan.accuracyStep = _facts.accuracyStep(target / 1000.0, static_cast<int>(numSteps));
        for (ViewPlan::Sheet& sheet : _plan.sheets)
        {
            _settled.push_back(sheet.settings);
            if (sheet.settings.frameTimeTarget == 0.0) continue;
            const auto steps = accuracySteps(sheet.settings);
            sheet.settings = steps[std::min<std::size_t>(_plan.accuracyStep, steps.size() - 1)];
        }
    }

    // As it is before anything is given up for time.
    const WaterSettings& settled(std::size_t i) const
    {
        return _settled.empty() ? _plan.sheets[i].settings : _settled[i];
    }

    ReflectedRays raysOf(const VisibleSheet& visible) const
    {
        ReflectingSheet sheet;
        sheet.hull = &visible.sheet->hull();
        sheet.eyeFromSurface = visible.eyeFromSurface;
        sheet.amplitude = visible.bounds->amplitude;
        sheet.side = visible.eyeAbove ? 1.0 : -1.0;
        return ReflectedRays(sheet, _facts.clipFromEye);
    }

    void planEffects()
    {
        for (std::size_t i = 0; i < _plan.sheets.size(); ++i)
        {
            ViewPlan::Sheet& sheet = _plan.sheets[i];
            sheet.effects = effectsOf(*_facts.sheets[i].water, _facts.effectView);
            sheet.looksAtScene =
                std::any_of(sheet.effects.begin(), sheet.effects.end(),
                            [](const Effect* effect) { return effect->looksAtScene(); });
        }
    }

    EyeImage eyeImage() const
    {
        bool copied = false;
        for (const ViewPlan::Sheet& sheet : _plan.sheets)
        {
            const CaptureKind kind = sheet.settings.capture;
            // An image that is drawn serves the waters that ask for a copy, too.
            if (kind == CaptureKind::VIEW || kind == CaptureKind::VIEW_AND_MIRROR)
                return EyeImage::DRAWN;
            copied = copied || kind == CaptureKind::FRAME || sheet.looksAtScene;
        }
        if (!copied) return EyeImage::NONE;
        // The frame of a nested view shows what it does not see.
        return _facts.nested ? EyeImage::DRAWN : EyeImage::COPIED;
    }

    bool mayDoWithoutMirror(std::size_t i) const
    {
        return isAutomatic(i) && _plan.sheets[i].settings.capture == CaptureKind::VIEW_AND_MIRROR;
    }

    void planEyeImage()
    {
        _plan.eyeImage = eyeImage();
        _plan.eyeCells = false;
        _plan.bandIsCut = false;
        scaleViews();
        if (_plan.eyeImage == EyeImage::NONE) return;

        GuardBandRequest given;
        GuardBandRequest beforeSaving; // whether a band serves must not depend on the time at hand
        NdcExtent mostRays;            // but for the steepest places of waves
        bool mirrorMayGo = false;
        for (std::size_t i = 0; i < _plan.sheets.size(); ++i)
        {
            const WaterSettings& settings = _plan.sheets[i].settings;
            if (!_plan.sheets[i].searchesEyeImage()) continue;
            const VisibleSheet& visible = _facts.sheets[i];
            _plan.eyeCells = _plan.eyeCells || settings.search == Search::HIERARCHICAL;
            if (!visible.water->getSky())
            {
                given.addDrawnSky();
                beforeSaving.addDrawnSky();
            }
            const bool asks = GuardBandRequest::asksForReach(settings) ||
                              GuardBandRequest::asksForReach(settled(i));
            const bool mayGo = mayDoWithoutMirror(i);
            const WaveBounds& waves = *visible.bounds;
            std::optional<ReflectedRays> rays;
            if (asks || mayGo) rays = raysOf(visible);
            const NdcExtent extent = asks ? rays->extent(waves.maxSlope) : NdcExtent();
            given.add(settings, extent);
            beforeSaving.add(settled(i), extent);
            if (!mayGo) continue;
            mirrorMayGo = true;
            const double mostSlopes = std::min(MOST_SLOPES * waves.rmsSlope, waves.maxSlope);
            mostRays = unite(mostRays, rays->extent(mostSlopes));
        }
        const NdcExtent scene =
            _facts.cullScene(_plan.eyeImage, mirrorMayGo ? beforeSaving : given);
        _plan.eyeSize.band = given.band(scene, _plan.eyeSize.view);
        _plan.eyeSize.capacity = given.largestSize(_plan.eyeSize.view);
        _plan.bandIsCut = !given.serves(given.reflected(), scene, _plan.eyeSize.view);
        _plan.scene.bandServes =
            mirrorMayGo && beforeSaving.serves(mostRays, scene, _facts.viewportSize);
        if (_plan.scene.bandServes)
            for (std::size_t i = 0; i < _plan.sheets.size(); ++i)
                if (mayDoWithoutMirror(i)) _plan.sheets[i].settings.capture = CaptureKind::VIEW;
    }

    // The most demanding sets the scale of all.
    void scaleViews()
    {
        double& scale = _plan.captureScale = 0.0;
        for (const ViewPlan::Sheet& sheet : _plan.sheets)
            scale = std::max(scale, sheet.settings.captureScale);
        const glm::ivec2 view(std::max(1L, std::lround(scale * _facts.viewport.x)),
                              std::max(1L, std::lround(scale * _facts.viewport.y)));
        _plan.eyeSize = {view, GuardBand(), view};
        _plan.mirrorSize = _plan.eyeSize;
    }

    void planMirrors()
    {
        _plan.mirrors.clear();
        _plan.amplitude = 0.0;
        for (std::size_t i = 0; i < _plan.sheets.size(); ++i)
        {
            ViewPlan::Sheet& sheet = _plan.sheets[i];
            _plan.amplitude = std::max(_plan.amplitude, _facts.sheets[i].bounds->amplitude);
            const CaptureKind kind = sheet.settings.capture;
            if (kind != CaptureKind::MIRROR && kind != CaptureKind::VIEW_AND_MIRROR) continue;
            const CaptureEye eye = mirrorOf(i);
            auto& mirrors = _plan.mirrors;
            auto mirror = std::find_if(mirrors.begin(), mirrors.end(),
                                       [&](const ViewPlan::Mirror& other)
                                       { return serveTogether(other.eye, eye); });
            if (mirror == mirrors.end()) mirror = mirrors.insert(mirror, {eye, false, false});
            mirror->cells = mirror->cells || sheet.settings.search == Search::HIERARCHICAL;
            sheet.mirror = static_cast<int>(mirror - mirrors.begin());
        }
    }

    // Rays that meet nothing see the sky of the first image that they are looked for in, where no
    // cube map is given: above, as most of the water in view has it.
    void planSky()
    {
        _plan.eyeSky = false;
        _plan.upEye = glm::dvec3(0.0);
        for (std::size_t i = 0; i < _plan.sheets.size(); ++i)
        {
            const VisibleSheet& visible = _facts.sheets[i];
            if (visible.water->getSky()) continue;
            _plan.upEye += glm::normalize(normalMatrix(visible.eyeFromSurface)[2]);
            if (_plan.sheets[i].searchesEyeImage())
                _plan.eyeSky = true;
            else
                _plan.mirrors[_plan.sheets[i].mirror].sky = true;
        }
        const double length = glm::length(_plan.upEye);
        if (length > 0.0) _plan.upEye /= length;
    }

    // Of those that are traced at a fraction of the resolution the largest wins.
    void planTrace()
    {
        double scale = 0.0;
        for (const ViewPlan::Sheet& sheet : _plan.sheets)
            if (sheet.settings.traceScale < 1.0) scale = std::max(scale, sheet.settings.traceScale);
        _plan.traceScale = scale > 0.0 ? scale : 1.0;
    }

    const ViewFacts& _facts;
    ViewPlan& _plan;
    std::vector<WaterSettings> _settled; // empty: nothing is given up for time
};

} // namespace

void osgWaterReflect::makePlan(const ViewFacts& facts, ViewPlan& plan)
{
    Planner(facts, plan).run();
}
