#include "Offscreen.h"

#include "Complain.h"
#include "StatusPage.h"

#include <osg/Timer>
#include <osgDB/Registry>

#include <algorithm>
#include <iostream>

#include <osgWaterReflect/offscreen/OffscreenContext.h>
#include <osgWaterReflect/settings/Members.h>

using namespace osgwaterviewer;

namespace
{

// Frames that are not timed: textures, meshes and the threads of the driver are set up in them.
const int WARM_UP_FRAMES = 1;

// Waits until the frame has been rendered, and takes it where that is wanted.
class FinishFrame : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override
    {
        if (image)
        {
            const osg::Viewport& view = *renderInfo.getCurrentCamera()->getViewport();
            image->readPixels(0, 0, view.width(), view.height(), GL_RGB, GL_UNSIGNED_BYTE);
        }
        else
            glFinish();
    }

    osg::ref_ptr<osg::Image> image;
};

// Whether the context can draw a picture of that size in one piece; drivers give larger ones, too.
bool checkSize(osg::GraphicsContext& context, const Picture& picture)
{
    GLint largest[2] = {0, 0};
    context.makeCurrent();
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest);
    context.releaseContext();
    if (picture.width <= largest[0] && picture.height <= largest[1]) return true;
    return complain("--size: expected at most " + std::to_string(largest[0]) + "x" +
                    std::to_string(largest[1]) + " here, got " + std::to_string(picture.width) +
                    "x" + std::to_string(picture.height));
}

// False, with a message, where there is no context of that size.
bool openContext(osgViewer::Viewer& viewer, const Picture& picture)
{
    const osg::ref_ptr<osg::GraphicsContext> context =
        osgWaterReflect::createOffscreenContext(picture.width, picture.height);
    if (!context) return false;
    osg::Camera& camera = *viewer.getCamera();
    camera.setGraphicsContext(context);
    camera.setViewport(0, 0, picture.width, picture.height);
    camera.setDrawBuffer(GL_FRONT); // a context without a window has one buffer
    camera.setReadBuffer(GL_FRONT);
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.realize();
    return checkSize(*context, picture);
}

void setView(osg::Camera& camera, const Scene& scene, const Picture& picture)
{
    const double aspectRatio = static_cast<double>(picture.width) / picture.height;
    double fovyDegrees, oldAspectRatio, zNear, zFar;
    camera.getProjectionMatrixAsPerspective(fovyDegrees, oldAspectRatio, zNear, zFar);
    camera.setProjectionMatrixAsPerspective(scene.fovyDegrees, aspectRatio, zNear, zFar);
    camera.setViewMatrixAsLookAt(scene.home.eye, scene.home.centre, scene.home.up());
}

// [ms]
double medianFrameTime(osgViewer::Viewer& viewer, const Picture& picture)
{
    std::vector<double> times;
    for (int i = 0; i < WARM_UP_FRAMES + picture.frames; ++i)
    {
        const osg::ElapsedTime clock;
        viewer.frame(picture.time);
        if (i >= WARM_UP_FRAMES) times.push_back(clock.elapsedTime_m());
    }
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    return times[times.size() / 2];
}

bool writePicture(const osg::Image& image, const std::string& file)
{
    const osgDB::ReaderWriter::WriteResult result =
        osgDB::Registry::instance()->writeImage(image, file, nullptr);
    return result.success() ||
           complain(file + ": expected a picture to be written, got: " + result.statusMessage());
}

void report(const Scene& scene, const Picture& picture, double frameTime)
{
    const WaterLook& look = scene.look;
    std::cout << "picture: " << picture.file << ", " << picture.width << "x" << picture.height
              << ", time " << picture.time << " s\n"
              << "model: " << scene.models << "\n"
              << "waters: " << scene.waters.size() << "\n"
              << "search: " << wordOf(osgWaterReflect::SEARCHES, look.reflection.search)
              << ", thickness " << look.reflection.thickness << "\n"
              << "waves: ";
    if (look.moving)
        std::cout << "steepness " << look.breeze.steepness << ", length " << look.breeze.length
                  << " m, toward " << look.breeze.directionDegrees << " degrees\n";
    else
        std::cout << "none\n";
    std::cout << "frame: " << frameTime << " ms, the median of " << picture.frames << "\n";
    std::cout << statusOf(scene.waters) << std::flush;
}

} // namespace

int osgwaterviewer::renderOffscreen(osgViewer::Viewer& viewer, const Scene& scene,
                                    const Picture& picture)
{
    if (!openContext(viewer, picture)) return 1;
    setView(*viewer.getCamera(), scene, picture);
    viewer.setSceneData(scene.root);
    const osg::ref_ptr<FinishFrame> finish = new FinishFrame;
    viewer.getCamera()->setFinalDrawCallback(finish);

    const double frameTime = medianFrameTime(viewer, picture);
    finish->image = new osg::Image;
    viewer.frame(picture.time);
    if (!writePicture(*finish->image, picture.file)) return 1;
    report(scene, picture, frameTime);
    return 0;
}
