#include "FramePace.h"

#include <osg/Camera>
#include <osg/Timer>
#include <osg/UserDataContainer>

using namespace osgWaterReflect;

FramePace::FramePace() : clock([] { return osg::Timer::instance()->time_s(); }) {}

FramePace& FramePace::of(osg::Camera& camera)
{
    static std::mutex adding; // two threads may cull one camera for two views
    const std::lock_guard<std::mutex> lock(adding);
    osg::UserDataContainer* const container = camera.getOrCreateUserDataContainer();
    for (unsigned int i = 0; i < container->getNumUserObjects(); ++i)
        if (auto* pace = dynamic_cast<FramePace*>(container->getUserObject(i))) return *pace;
    const osg::ref_ptr<FramePace> pace = new FramePace;
    container->addUserObject(pace);
    return *pace;
}

int FramePace::step(unsigned int frame, double target, int numSteps)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_control || numSteps != _numSteps)
        _control.emplace(numSteps);
    else if (frame == _frame)
        return _control->step();
    _numSteps = numSteps;
    _frame = frame;
    _control->frame(clock(), target);
    return _control->step();
}
