#include "FramePace.h"

#include <osg/Camera>
#include <osg/Timer>
#include <osg/observer_ptr>

#include <list>

using namespace osgWaterReflect;

FramePace::FramePace() : clock([] { return osg::Timer::instance()->time_s(); }) {}

osg::ref_ptr<FramePace> FramePace::of(osg::Camera& camera)
{
    struct Paced
    {
        osg::observer_ptr<osg::Camera> camera;
        osg::ref_ptr<FramePace> pace;
    };
    static std::mutex mutex;
    static std::list<Paced> all;
    const std::lock_guard<std::mutex> lock(mutex);
    all.remove_if([](const Paced& paced) { return !paced.camera.valid(); });
    for (const Paced& paced : all)
        if (paced.camera == &camera) return paced.pace;
    all.push_back({&camera, new FramePace});
    return all.back().pace;
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
