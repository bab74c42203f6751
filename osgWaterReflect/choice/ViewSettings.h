#ifndef OSGWATERREFLECT_CHOICE_VIEWSETTINGS_H
#define OSGWATERREFLECT_CHOICE_VIEWSETTINGS_H

#include "../capture/WaterFinder.h"
#include "AutomaticChoice.h"
#include "FramePace.h"

#include <optional>

namespace osgWaterReflect
{

/// What the waters of a view are drawn with, one cull of one camera: their settings with what is
/// automatic settled, and as accurate as the view's time allows. All the water in view has a say in
/// both; it is looked for when the first is met whose settings leave something open.
class ViewSettings
{
public:
    /// A new cull.
    void begin() { _seen.reset(); }

    /// What water is drawn with. Where the capture was left open, VIEW_AND_MIRROR may turn out to
    /// be more than is needed, when the view's capture has been arranged: see bandServes().
    ///   view  in the middle of its cull
    ReflectionSettings of(osgUtil::CullVisitor& view, const WaterSurface& water);

    /// Whether that water does without the mirrored capture where the view's band serves.
    static bool bandDecides(const WaterSurface& water)
    {
        return water.getReflection().capture == CaptureKind::AUTOMATIC;
    }

private:
    struct Seen
    {
        ViewFacts facts;
        int step = 0;
    };
    Seen look(osgUtil::CullVisitor& view);

    std::optional<Seen> _seen;
    osg::ref_ptr<WaterFinder> _finder; // null until something is left open
};

} // namespace osgWaterReflect

#endif
