#include "StageClock.h"

#include <osg/Timer>

#include <string>

using namespace osgwaterbench;

namespace
{

// In the water's bin, before the water: after all that is to be drawn before that.
const int WATER_BIN = 9;
const int FIRST_IN_BIN = -1;

double now()
{
    return osg::Timer::instance()->time_m();
}

} // namespace

class StageClock::MarkCallback : public osg::Camera::DrawCallback
{
public:
    MarkCallback(StageClock& clock, Mark mark) : _clock(clock), _mark(mark) {}
    void operator()(osg::RenderInfo& renderInfo) const override { _clock.take(_mark, renderInfo); }

private:
    StageClock& _clock;
    Mark _mark;
};

// It has no bound: never culled, and without a part in the near and far planes.
class StageClock::MarkDrawable : public osg::Drawable
{
public:
    explicit MarkDrawable(StageClock& clock) : _clock(&clock)
    {
        setSupportsDisplayList(false);
        setCullingActive(false);
        getOrCreateStateSet()->setRenderBinDetails(FIRST_IN_BIN, "RenderBin");
    }
    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    void drawImplementation(osg::RenderInfo& renderInfo) const override
    {
        _clock->take(Mark::WATER_BEGIN, renderInfo);
    }

private:
    osg::ref_ptr<StageClock> _clock;
};

StageClock::Way StageClock::wayOfCurrentContext()
{
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (renderer.find(software) != std::string::npos) return Way::FINISH;
    return Way::TIMESTAMPS;
}

void StageClock::watchImage(osg::Camera& camera)
{
    camera.setPreDrawCallback(new MarkCallback(*this, Mark::IMAGE_BEGIN));
    camera.setPostDrawCallback(new MarkCallback(*this, Mark::IMAGE_END));
}

void StageClock::watchPyramid(osg::Camera& camera)
{
    camera.setPreDrawCallback(new MarkCallback(*this, Mark::PYRAMID_BEGIN));
    camera.setPostDrawCallback(new MarkCallback(*this, Mark::PYRAMID_END));
}

void StageClock::watchTrace(osg::Camera& camera)
{
    camera.setPreDrawCallback(new MarkCallback(*this, Mark::TRACE_BEGIN));
    camera.setPostDrawCallback(new MarkCallback(*this, Mark::TRACE_END));
}

osg::ref_ptr<osg::Node> StageClock::createWaterMark()
{
    const osg::ref_ptr<osg::Group> mark = new osg::Group;
    mark->getOrCreateStateSet()->setRenderBinDetails(WATER_BIN, "RenderBin");
    mark->setCullingActive(false);
    mark->addChild(new MarkDrawable(*this));
    return mark;
}

void StageClock::watchFrame(osg::Camera& camera)
{
    camera.setFinalDrawCallback(new MarkCallback(*this, Mark::FRAME_END));
}

void StageClock::start()
{
    _marks.clear();
    _started = now();
}

void StageClock::take(Mark mark, osg::RenderInfo& renderInfo)
{
    GLuint query = 0;
    if (_way == Way::TIMESTAMPS)
    {
        _gl = renderInfo.getState()->get<osg::GLExtensions>();
        _gl->glGenQueries(1, &query);
        _gl->glQueryCounter(query, GL_TIMESTAMP);
    }
    if (_way == Way::FINISH || mark == Mark::FRAME_END) glFinish();
    const double time = now();
    _marks.push_back({mark, time, query});
    if (mark != Mark::FRAME_END) return;

    // Everything is done by now: the answers are there.
    _ended = time;
    for (MarkedTime& marked : _marks)
    {
        if (!marked.query) continue;
        GLuint64 nanoseconds = 0;
        _gl->glGetQueryObjectui64v(marked.query, GL_QUERY_RESULT, &nanoseconds);
        _gl->glDeleteQueries(1, &marked.query);
        marked.query = 0;
        marked.time = 1e-6 * static_cast<double>(nanoseconds);
    }
}

FrameTime StageClock::read() const
{
    FrameTime result;
    double begin = 0.0; // of what is rendered before the frame
    for (const MarkedTime& marked : _marks)
    {
        const double sinceBegin = marked.time - begin;
        if (marked.mark == Mark::IMAGE_BEGIN || marked.mark == Mark::PYRAMID_BEGIN ||
            marked.mark == Mark::TRACE_BEGIN)
            begin = marked.time;
        if (marked.mark == Mark::IMAGE_END || marked.mark == Mark::PYRAMID_END)
            result.image += sinceBegin;
        if (marked.mark == Mark::PYRAMID_END) result.pyramid += sinceBegin;
        if (marked.mark == Mark::TRACE_END) result.trace += sinceBegin;
        if (marked.mark == Mark::WATER_BEGIN) result.trace += _marks.back().time - marked.time;
    }
    result.frame = _ended - _started;
    return result;
}
