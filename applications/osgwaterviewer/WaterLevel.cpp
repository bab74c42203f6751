#include "WaterLevel.h"

#include "Complain.h"

using namespace osgwaterviewer;

namespace
{

// [1] Half the water's side over the models' radius. From the home view, four radii away and less
// than half of one above the water, it ends one degree below the horizon.
const double HALF_SIDE = 25.0;

} // namespace

double WaterLevel::over(const osg::BoundingBoxd& models) const
{
    return z ? *z : models.zMin() + AUTOMATIC_HEIGHT * (models.zMax() - models.zMin());
}

osg::ref_ptr<osgWaterReflect::WaterSurface>
WaterLevel::createWater(const osg::BoundingBoxd& models) const
{
    if (!models.valid() || !(models.radius() > 0.0))
    {
        complain("--water: expected models with something to be seen, got none");
        return nullptr;
    }
    if (!z && !(models.zMax() > models.zMin()))
    {
        complain("--water auto: expected models of some height, got flat ones; give a level");
        return nullptr;
    }
    const osg::Vec3d centre(models.center().x(), models.center().y(), over(models));
    const double side = 2.0 * HALF_SIDE * models.radius();
    return osgWaterReflect::WaterSurface::createRectangle(centre, osg::Vec3(side, 0.0f, 0.0f),
                                                          osg::Vec3(0.0f, side, 0.0f));
}
