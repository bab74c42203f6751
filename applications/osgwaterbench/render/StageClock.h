#ifndef OSGWATERBENCH_STAGECLOCK_H
#define OSGWATERBENCH_STAGECLOCK_H

#include <osg/Camera>
#include <osg/Drawable>
#include <osg/GLExtensions>
#include <osg/Group>

#include <vector>

namespace osgwaterbench
{

/// Where the time of a frame goes [ms].
struct FrameTime
{
    double image = 0.0;   ///< rendering the images that reflections are looked up in, and pyramids
    double trace = 0.0;   ///< drawing the water, and tracing it before: vertices, search, shading
    double frame = 0.0;   ///< everything, cull and draw, until the last pixel is done
    double pyramid = 0.0; ///< the part of image that pyramids take
};

/// Takes the time at marks between the stages of a frame.
///
/// On a software rasteriser, whose timer queries are not to be trusted, everything drawn so far is
/// finished at each mark; on a GPU it is asked for its own time there, and nothing waits.
class StageClock : public osg::Referenced
{
public:
    enum class Way
    {
        FINISH,    ///< glFinish and the CPU's clock
        TIMESTAMPS ///< GL_TIMESTAMP queries
    };

    /// What suits the context that is current.
    static Way wayOfCurrentContext();

    void setWay(Way way) { _way = way; }

    /// The image of a camera counts as one that reflections are looked up in, or as a part of a
    /// pyramid. It must not be watched by another clock.
    void watchImage(osg::Camera& camera);
    void watchPyramid(osg::Camera& camera);

    /// What a camera draws counts as trace. It must not be watched by another clock.
    void watchTrace(osg::Camera& camera);

    /// To be drawn between what is opaque and the water.
    osg::ref_ptr<osg::Node> createWaterMark();

    /// The view's camera, in which nothing is drawn after the water.
    void watchFrame(osg::Camera& camera);

    /// To be called before each frame.
    void start();

    /// Of the frame that has just been rendered.
    FrameTime read() const;

private:
    enum class Mark
    {
        IMAGE_BEGIN,
        IMAGE_END,
        PYRAMID_BEGIN,
        PYRAMID_END,
        TRACE_BEGIN,
        TRACE_END,
        WATER_BEGIN,
        FRAME_END
    };
    struct MarkedTime
    {
        Mark mark;
        double time;  // [ms]
        GLuint query; // 0 where the time is known
    };
    class MarkCallback;
    class MarkDrawable;

    void take(Mark mark, osg::RenderInfo& renderInfo);

    Way _way = Way::FINISH;
    double _started = 0.0; // [ms] of the CPU's clock
    double _ended = 0.0;
    std::vector<MarkedTime> _marks;
    osg::ref_ptr<osg::GLExtensions> _gl;
};

} // namespace osgwaterbench

#endif
