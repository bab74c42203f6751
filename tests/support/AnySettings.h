#ifndef OSGWATERREFLECT_TESTS_SUPPORT_ANYSETTINGS_H
#define OSGWATERREFLECT_TESTS_SUPPORT_ANYSETTINGS_H

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/WaterSurface>

#include <random>
#include <vector>

/// Numbers of every size, limits and the numbers next to them, and what is none. The same ones in
/// each run.
class AnyNumber
{
public:
    double operator()();
    double between(double low, double high);
    int integer(int low, int high);
    bool once(int in) { return integer(1, in) == 1; }

private:
    std::mt19937 _random{4};
};

/// One or two members of any value, about half of them out of range; kinds of any.
osgWaterReflect::ReflectionSettings anyReflection(AnyNumber& any);
osgWaterReflect::ViewSettings anyViewSettings(AnyNumber& any);
osgWaterReflect::WaterOptics anyOptics(AnyNumber& any);
osgWaterReflect::SurfaceDetail anyDetail(AnyNumber& any);

/// None to four waves.
std::vector<osgWaterReflect::TrochoidalWave> anyWaves(AnyNumber& any);

#endif
