#include "support/Catch.h"

#include <osgWaterReflect/WaterSurface>

TEST_CASE("settings")
{
    osg::ref_ptr<osgWaterReflect::WaterSurface> water = new osgWaterReflect::WaterSurface;
    osgWaterReflect::ReflectionSettings settings;
    settings.thickness = -1;
    CHECK_FALSE(water->setReflection(settings));
}
