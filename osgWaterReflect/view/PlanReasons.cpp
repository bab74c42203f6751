#include "PlanReasons.h"

using namespace osgWaterReflect;

namespace
{

struct Reason
{
    bool done;
    const char* text;
};

// Of one sheet's decisions.
class Explanation
{
public:
    Explanation(const ViewFacts& facts, const ViewPlan& plan, std::size_t i) :
        _facts(facts), _plan(plan), _sheet(plan.sheets[i]), _water(*facts.sheets[i].water),
        _asked(_water.getReflection()), _automatic(_asked.capture == CaptureKind::AUTOMATIC)
    {
    }

    Reason eyeImage() const
    {
        if (!_sheet.searchesEyeImage() && _sheet.looksAtScene)
            return {true, "an effect looks at the scene"};
        if (!_sheet.usesEyeImage())
            return {false, _automatic ? "all water in view is calm and in one plane: its mirrored "
                                        "image shows all that it reflects"
                                      : "CaptureKind::MIRROR is asked for"};
        if (!_automatic) return {true, "it is asked for"};
        if (!_plan.scene.redrawsAlike)
            return {true, "shadows would differ in a mirrored image, as in any second drawing"};
        if (_plan.scene.planes > 1) return {true, "water in view lies in several planes"};
        return {true, _plan.scene.calm ? "the mirrored image is given up for the frame's time"
                                       : "water in view moves"};
    }

    Reason frameCopy() const
    {
        const bool asked = _sheet.settings.capture == CaptureKind::FRAME;
        if (!_sheet.usesEyeImage()) return {false, "there is no image of the eye"};
        if (_plan.eyeImage == EyeImage::COPIED)
        {
            if (!_sheet.searchesEyeImage()) return {true, "an effect looks at the scene"};
            if (_asked.capture == CaptureKind::FRAME)
                return {true, "CaptureKind::FRAME is asked for"};
            return {true, _plan.scene.redrawsAlike
                              ? "a second drawing is given up for the frame's time"
                              : "shadows would differ in a second drawing"};
        }
        if (!asked) return {false, "the image of the eye is drawn"};
        return {false, _facts.nested ? "the view is drawn into the image of another camera, whose "
                                       "frame it would copy: the image of the eye is drawn instead"
                                     : "another water of the view asks for an image that is drawn"};
    }

    Reason mirroredImage() const
    {
        if (_sheet.mirror >= 0)
        {
            if (!_automatic) return {true, "it is asked for"};
            return {true, _plan.scene.calm ? "calm water in one plane is exact in it"
                                           : "the guard band does not reach as far as most rays"};
        }
        if (!_automatic)
        {
            const bool givenUp = _asked.capture == CaptureKind::MIRROR ||
                                 _asked.capture == CaptureKind::VIEW_AND_MIRROR;
            return {false, givenUp ? "it is given up for the frame's time" : "it is not asked for"};
        }
        if (!_plan.scene.redrawsAlike) return {false, "shadows would differ in a second drawing"};
        if (_plan.scene.planes > 1) return {false, "water in view lies in several planes"};
        return {false, _plan.scene.bandServes ? "the image of the eye reaches as far as most rays"
                                              : "it is given up for the frame's time"};
    }

    Reason guardBand() const
    {
        if (!_sheet.searchesEyeImage()) return {false, "a mirrored image has none"};
        if (_plan.eyeSize.whole() != _plan.eyeSize.view)
            return {true, _plan.bandIsCut ? "reflected rays leave the view; it is cut down to its "
                                            "ceiling"
                                          : "reflected rays leave the view, or it is FIXED"};
        if (_sheet.settings.guardBand == GuardBandKind::NONE)
            return {false, "GuardBandKind::NONE is asked for, or all that there is time for"};
        return {false, _plan.bandIsCut ? "its ceiling leaves none"
                                       : "no reflected ray leaves the view, or nothing is there"};
    }

    Reason depthCells() const
    {
        const bool read = _sheet.settings.search == Search::HIERARCHICAL;
        return {read, read ? "the hierarchical search reads them" : "the search reads none"};
    }

    Reason lowResTrace() const
    {
        if (_sheet.settings.traceScale >= 1.0) return {false, "its traceScale is 1"};
        return {true, _sheet.settings.traceScale < _plan.traceScale
                          ? "its traceScale is below 1; another water of the view asks for a larger"
                          : "its traceScale is below 1"};
    }

    Reason ownCaptureScale() const
    {
        const bool own = _sheet.settings.captureScale == _plan.captureScale;
        return {own, own ? "no water of the view asks for a larger one"
                         : "another water of the view asks for a larger one"};
    }

    Reason fullAccuracy() const
    {
        if (_sheet.settings.frameTimeTarget == 0.0) return {true, "no frame time is to be kept"};
        return {_plan.accuracyStep == 0, _plan.accuracyStep == 0
                                             ? "frames keep their time"
                                             : "frames would take longer than frameTimeTarget"};
    }

private:
    const ViewFacts& _facts;
    const ViewPlan& _plan;
    const ViewPlan::Sheet& _sheet;
    const WaterSurface& _water;
    const ReflectionSettings& _asked;
    const bool _automatic;
};

} // namespace

void osgWaterReflect::explain(const ViewFacts& facts, ViewPlan& plan)
{
    for (std::size_t i = 0; i < plan.sheets.size(); ++i)
    {
        auto& decisions = plan.sheets[i].decisions;
        decisions.clear();
        const Explanation of(facts, plan, i);
        const auto add = [&](const char* subject, const Reason& reason) {
            decisions.push_back({subject, reason.done, reason.text});
        };
        add("image of the eye", of.eyeImage());
        add("copied from the frame", of.frameCopy());
        add("mirrored image", of.mirroredImage());
        add("guard band", of.guardBand());
        add("depth cells", of.depthCells());
        add("trace at a fraction of the resolution", of.lowResTrace());
        add("captureScale of its own", of.ownCaptureScale());
        add("all the accuracy asked for", of.fullAccuracy());
        for (const auto& effect : effectList())
        {
            const CalledFor called = effect->calledFor(*facts.sheets[i].water, facts.effectView);
            add(effect->getName(), {bool(called), called ? "it is called for" : called.whyNot});
        }
    }
}
