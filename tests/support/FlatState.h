#ifndef OSGWATERREFLECT_TESTS_SUPPORT_FLATSTATE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_FLATSTATE_H

#include <osgWaterReflect/WaveState>

/// Waves that are none, and set no uniforms.
class FlatState : public osgWaterReflect::WaveState
{
public:
    double getHeight(const osg::Vec2d&) const override { return 0.0; }
    osg::Vec3d getNormal(const osg::Vec2d&) const override { return osg::Vec3d(0, 0, 1); }
    void apply(osg::StateSet&, const osg::Vec2d&) const override {}
};

#endif
