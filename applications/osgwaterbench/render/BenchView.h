#ifndef OSGWATERBENCH_BENCHVIEW_H
#define OSGWATERBENCH_BENCHVIEW_H

#include "../methods/MethodScope.h"
#include "../scenes/Scenes.h"
#include "StageClock.h"

#include <osg/Image>
#include <osg/Texture2D>
#include <osgViewer/Viewer>

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace osgwaterbench
{

/// An image that reflections were looked up in, read back, and the matrices it was taken with, for
/// row vectors.
struct SearchedImage
{
    osg::ref_ptr<osg::Image> windowZ; ///< floats
    osg::Matrixd eyeFromWorld;
    osg::Matrixd clipFromEye;
};

/// A scene in an offscreen context, its water drawn by one method after another.
class BenchView
{
public:
    enum class Purpose
    {
        MEASURE, ///< renders to RGBA32F, and every frame is read back
        TIME     ///< renders to RGBA8, and stays on the rasteriser
    };

    using Waters = std::vector<osg::ref_ptr<osgWaterReflect::WaterSurface>>;

    /// Throws std::runtime_error where there is no context of that size.
    BenchView(const BenchScene& scene, const glm::ivec2& size, Purpose purpose);
    ~BenchView();
    BenchView(const BenchView&) = delete;
    BenchView& operator=(const BenchView&) = delete;

    void setWaves(osgWaterReflect::WaveModel* waves);
    void setMethod(const Method& method) { _method = method; }

    /// Waters in place of the scene's own, whatever the method; none for frames without water.
    void setWaters(const Waters& waters);

    /// Renders a frame and returns it; the image stays valid until the next. MEASURE only.
    const osg::Image& render(osgWaterReflect::WaterSurface::DebugView debugView);

    /// What the last frame's reflections were looked up in: the captures in the order that they are
    /// searched in, or the rival's mirrored image.
    std::vector<SearchedImage> searchedImages();

    /// Renders a frame and says where its time went. TIME only.
    FrameTime time();

    const osg::Camera& camera() const { return *_viewer.getCamera(); }
    const glm::ivec2& size() const { return _size; }

private:
    void frame();
    std::vector<osg::Camera*> captureCameras();
    void watchImages();

    glm::ivec2 _size;
    Purpose _purpose;
    osg::ref_ptr<StageClock> _clock = new StageClock;
    osg::ref_ptr<osg::Image> _picture; // null unless MEASURE
    osg::Plane _stillWater;
    TestBed _bed;
    osg::ref_ptr<osg::Group> _waters = new osg::Group;
    Method _method = libraryMethod("default", {});
    std::string _watchedMethod; // whose images' cameras the clock knows
    osgViewer::Viewer _viewer;
};

} // namespace osgwaterbench

#endif
