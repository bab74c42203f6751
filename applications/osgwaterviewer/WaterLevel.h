#ifndef OSGWATERVIEWER_WATERLEVEL_H
#define OSGWATERVIEWER_WATERLEVEL_H

#include <osg/BoundingBox>

#include <osgWaterReflect/WaterSurface>

#include <optional>

namespace osgwaterviewer
{

/// Where water is laid through models that have none.
struct WaterLevel
{
    std::optional<double> z; ///< [world units]; none to choose it from the models' height

    /// A tenth of the height above the lowest point: a car stands in it to its hubs, a duck swims
    /// in it, of a terrain the valleys are flooded; and nine tenths of all of them are mirrored.
    /// Up is z. Most readers of OSG turn models of other formats so; where the format does not say
    /// what is up (STL, PLY), OSG's pseudo-loader does it: statue.ply.90,0,0.rot.
    static constexpr double AUTOMATIC_HEIGHT = 0.1;

    /// The height [world units] in models of a bound.
    double over(const osg::BoundingBoxd& models) const;

    /// A square of still water about models, wide enough for its end to look like the horizon.
    /// Null, with a message, where they have no extent.
    osg::ref_ptr<osgWaterReflect::WaterSurface> createWater(const osg::BoundingBoxd& models) const;
};

} // namespace osgwaterviewer

#endif
