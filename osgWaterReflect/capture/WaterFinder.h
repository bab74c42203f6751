#ifndef OSGWATERREFLECT_CAPTURE_WATERFINDER_H
#define OSGWATERREFLECT_CAPTURE_WATERFINDER_H

#include "CaptureVisitor.h"
#include "MirroredEye.h"

#include <string>

namespace osgWaterReflect
{

/// Water of which at least one sheet is in a view.
struct SeenWater
{
    const WaterSurface* water;
    std::vector<CaptureEye> mirroredEyes; ///< of the sheets in view
};

/// Finds all the water that a view will come to in its cull, at the first that it does: by a cull
/// of groups alone. What is drawn is passed over, and with it what other cameras draw.
class WaterFinder : public CaptureVisitor
{
public:
    WaterFinder() : _stage(new osgUtil::RenderStage) { _stage->setViewport(new osg::Viewport); }
    META_NodeVisitor(osgWaterReflect, WaterFinder)

    /// Water, in the order of the view's traversal.
    ///   view  in the middle of its cull
    const std::vector<SeenWater>& find(osgUtil::CullVisitor& view);

    /// The shadow technique in the view's scene, by its class, that fits its shadows to each cull,
    /// so that a scene drawn once more has others; empty: none.
    const std::string& unsteadyShadows() const { return _unsteadyShadows; }

    void meet(const WaterSurface& water,
              const std::vector<osg::ref_ptr<StillWater>>& sheets) override;

    using CaptureVisitor::apply;
    void apply(osg::Group& group) override;
    void apply(osg::Camera& camera) override;
    void apply(osg::Geode& geode) override;
    void apply(osg::Billboard&) override {}
    void apply(osg::Drawable&) override {}

private:
    osg::ref_ptr<osgUtil::RenderStage> _stage; // nothing is drawn in it
    std::vector<SeenWater> _seen;
    std::string _unsteadyShadows;
};

} // namespace osgWaterReflect

#endif
