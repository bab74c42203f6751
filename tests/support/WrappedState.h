#ifndef OSGWATERREFLECT_TESTS_SUPPORT_WRAPPEDSTATE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_WRAPPEDSTATE_H

#include <osgWaterReflect/WaveState>

#include <osg/ref_ptr>

/// The waves of another state, for tests that watch what becomes of a state.
class WrappedState : public osgWaterReflect::WaveState
{
public:
    explicit WrappedState(const osgWaterReflect::WaveState& waves) : _waves(&waves) {}

    double getHeight(const osg::Vec2d& place) const override { return _waves->getHeight(place); }
    osg::Vec3d getNormal(const osg::Vec2d& place) const override
    {
        return _waves->getNormal(place);
    }
    void apply(osg::StateSet& stateSet, const osg::Vec2d& anchor) const override
    {
        _waves->apply(stateSet, anchor);
    }

private:
    const osg::ref_ptr<const osgWaterReflect::WaveState> _waves;
};

#endif
