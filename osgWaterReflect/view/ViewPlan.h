#ifndef OSGWATERREFLECT_VIEW_VIEWPLAN_H
#define OSGWATERREFLECT_VIEW_VIEWPLAN_H

#include "../band/GuardBandRequest.h"
#include "../capture/Capture.h"
#include "../capture/MirroredEye.h"
#include "../effects/EffectList.h"
#include "../water/VisibleSheet.h"
#include "../water/WaterSettings.h"
#include "AutomaticChoice.h"

#include <osgWaterReflect/WaterStatus>

#include <functional>
#include <vector>

namespace osgWaterReflect
{

/// How the image is made that a view's eye sees of the scene.
enum class EyeImage
{
    NONE,
    DRAWN, ///< DrawnCapture
    COPIED ///< CopiedCapture
};

/// What is drawn for the water of one view in one frame, and why: made when all of it is known and
/// before anything is captured. Captures, images, traces and draws carry it out and decide nothing.
struct ViewPlan
{
    struct Sheet
    {
        WaterSettings settings;             ///< nothing in them is AUTOMATIC
        int mirror = -1;                    ///< index of its mirrored image; below 0: none
        std::vector<const Effect*> effects; ///< that it calls for
        bool looksAtScene = false;          ///< some of them do
        std::vector<WaterStatus::Decision> decisions; ///< what may be done, and why it is or is not
        /// Its rays are looked for in it.
        bool searchesEyeImage() const { return settings.capture != CaptureKind::MIRROR; }
        bool usesEyeImage() const { return searchesEyeImage() || looksAtScene; }
    };

    struct Mirror
    {
        CaptureEye eye;
        bool cells = false; ///< some search reads its cells
        bool sky = false;   ///< its sky is seen
    };

    std::vector<Sheet> sheets; ///< as the visible ones are
    SceneFacts scene;          ///< what was automatic is settled by
    EyeImage eyeImage = EyeImage::NONE;
    bool eyeCells = false;  ///< some search reads the eye image's cells
    bool eyeSky = false;    ///< the eye image's sky is seen
    bool bandIsCut = false; ///< the guard band falls short of what was asked for
    double captureScale = 1.0;
    CaptureSize eyeSize;
    std::vector<Mirror> mirrors;
    CaptureSize mirrorSize;
    glm::dvec3 upEye{0.0};   ///< normal of the still water, in eye space: where the sky is
    double amplitude = 0.0;  ///< [local units] of the highest waves
    double traceScale = 1.0; ///< [1] of the image that rays are traced in first; 1: there is none
    int accuracyStep = 0;    ///< that frames have time for; 0: as accurate as was asked for
};

/// What a plan is made from.
struct ViewFacts
{
    explicit ViewFacts(const std::vector<VisibleSheet>& visible) : sheets(visible) {}

    const std::vector<VisibleSheet>& sheets;
    glm::dmat4 clipFromEye{1.0};
    glm::ivec2 viewportSize{0};
    glm::dvec2 viewport{0.0}; ///< [pixels] its sides, maybe with a fraction
    EffectView effectView;    ///< what effects may ask about
    bool nested = false;      ///< the view is drawn into another's image
    bool redrawsAlike = true; ///< the scene drawn once more has the same shadows

    /// The step of accuracy that there is time for, below a number of steps, where frames are to
    /// take so long [s].
    std::function<int(double target, int numSteps)> accuracyStep;

    /// Culls the scene for an image of the eye, as far as a request may need it, and tells how far
    /// the scene reaches. Asked once at most.
    std::function<NdcExtent(EyeImage image, const GuardBandRequest& request)> cullScene;
};

/// Makes the plan of a view that sees at least one sheet, into one whose memory is used again.
void makePlan(const ViewFacts& facts, ViewPlan& plan);

} // namespace osgWaterReflect

#endif
