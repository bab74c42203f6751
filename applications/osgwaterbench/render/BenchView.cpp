#include "BenchView.h"

#include "../methods/NotCaptured.h"

#include <osgWaterReflect/capture/Capture.h>
#include <osgWaterReflect/capture/FrameCopy.h>
#include <osgWaterReflect/offscreen/OffscreenContext.h>
#include <osgWaterReflect/water/LowResTrace.h>

#include <osg/Geode>
#include <osgUtil/RenderStage>
#include <osgViewer/Renderer>

#include <cstring>
#include <stdexcept>

using namespace osgwaterbench;
using osgWaterReflect::Capture;
using osgWaterReflect::FrameCopy;
using osgWaterReflect::LowResTrace;
using osgWaterReflect::WaterSurface;

namespace
{

// [m] A wide range: OSG fits it to what is in view.
const double Z_NEAR = 0.1;
const double Z_FAR = 1000.0;

osg::Texture2D* windowZTexture(const osg::Camera& camera)
{
    const auto found = camera.getBufferAttachmentMap().find(osg::Camera::DEPTH_BUFFER);
    return found == camera.getBufferAttachmentMap().end()
               ? nullptr
               : dynamic_cast<osg::Texture2D*>(found->second._texture.get());
}

// Of the part that a viewport covers.
osg::ref_ptr<osg::Image> readWindowZ(osg::State& state, const osg::Texture2D& texture,
                                     const osg::Viewport& viewport)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(texture.getTextureWidth(), texture.getTextureHeight(), 1, GL_LUMINANCE,
                         GL_FLOAT);
    state.applyTextureAttribute(0, &texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, image->data());

    const osg::ref_ptr<osg::Image> used = new osg::Image;
    used->allocateImage(viewport.width(), viewport.height(), 1, GL_LUMINANCE, GL_FLOAT);
    for (int row = 0; row < used->t(); ++row)
        std::memcpy(used->data(0, row), image->data(0, row), used->getRowSizeInBytes());
    return used;
}

// The cameras of the captures among the stages that are rendered before a view: the eye's, then the
// mirrored eye's.
std::vector<osg::Camera*> captureCamerasIn(osgUtil::RenderStage& stage)
{
    std::vector<osg::Camera*> cameras;
    for (const char* name : {Capture::CAMERA_NAME, Capture::MIRROR_CAMERA_NAME})
        for (const auto& before : stage.getPreRenderList())
        {
            osg::Camera* const camera = before.second->getCamera();
            if (camera && camera->getName() == name) cameras.push_back(camera);
        }
    return cameras;
}

} // namespace

BenchView::BenchView(const BenchScene& scene, const glm::ivec2& size, Purpose purpose) :
    _size(size), _purpose(purpose), _stillWater(osg::Vec3d(0, 0, 1), -scene.waterLevel)
{
    const osg::ref_ptr<osg::GraphicsContext> context =
        osgWaterReflect::createOffscreenContext(size.x, size.y);
    if (!context)
        throw std::runtime_error("expected an offscreen context of " + std::to_string(size.x) +
                                 "x" + std::to_string(size.y) + ", got none");
    osg::Camera& camera = *_viewer.getCamera();
    camera.setGraphicsContext(context);
    camera.setViewport(0, 0, size.x, size.y);
    camera.setDrawBuffer(GL_FRONT); // a context without a window has one buffer
    camera.setReadBuffer(GL_FRONT);
    camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera.setViewMatrixAsLookAt(scene.eye, scene.centre, osg::Vec3d(0, 0, 1));
    camera.setProjectionMatrixAsPerspective(scene.fovyDegrees, static_cast<double>(size.x) / size.y,
                                            Z_NEAR, Z_FAR);
    if (purpose == Purpose::MEASURE)
    {
        _picture = new osg::Image;
        _picture->allocateImage(size.x, size.y, 1, GL_RGBA, GL_FLOAT);
        _picture->setInternalTextureFormat(GL_RGBA32F_ARB);
        camera.attach(osg::Camera::COLOR_BUFFER0, _picture);
    }
    else
        camera.attach(osg::Camera::COLOR_BUFFER0, GL_RGBA8);
    camera.attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT24);

    const GLint mirrorFormat = purpose == Purpose::MEASURE ? GL_RGBA32F_ARB : GL_RGBA8;
    _bed.water = scene.water;
    _bed.water->setReflection(searchOfView()); // until a method is set
    _bed.scene = new osg::Group;
    _bed.scene->addChild(scene.scene);
    _bed.mirror = new MirrorCamera(size.x, size.y, mirrorFormat);
    _bed.mirror->addChild(scene.scene);
    _bed.mirror->setNodeMask(0u);
    _waters->addChild(scene.water);

    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(_bed.mirror);
    root->addChild(_bed.scene);
    root->addChild(_waters);
    if (purpose == Purpose::TIME)
    {
        const osg::ref_ptr<osg::Group> marks = new osg::Group;
        marks->addCullCallback(new NotCaptured);
        marks->addChild(_clock->createWaterMark());
        root->addChild(marks);
        _clock->watchFrame(camera);
    }
    _viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    // OSG would keep this thread to the first processor, and with it all that inParallel starts.
    _viewer.setUseConfigureAffinity(false);
    _viewer.setKeyEventSetsDone(0);
    _viewer.setSceneData(root);
    _viewer.realize();
    context->makeCurrent();
    _clock->setWay(StageClock::wayOfCurrentContext());
}

BenchView::~BenchView() = default;

void BenchView::setWaves(osgWaterReflect::WaveModel* waves)
{
    _bed.water->setWaves(waves);
}

void BenchView::setWaters(const Waters& waters)
{
    _waters->removeChildren(0, _waters->getNumChildren());
    for (const auto& water : waters)
        _waters->addChild(water);
}

void BenchView::frame()
{
    if (_method.mirror) _bed.mirror->follow(camera(), _stillWater, Z_FAR);
    _viewer.frame(0.0);
}

const osg::Image& BenchView::render(WaterSurface::DebugView debugView)
{
    const MethodScope scope(_method, _bed);
    _bed.water->setDebugView(debugView);
    frame();
    return *_picture;
}

std::vector<osg::Camera*> BenchView::captureCameras()
{
    auto& renderer = dynamic_cast<osgViewer::Renderer&>(*_viewer.getCamera()->getRenderer());
    for (unsigned int i = 0; i < 2; ++i)
    {
        const auto cameras = captureCamerasIn(*renderer.getSceneView(i)->getRenderStage());
        if (!cameras.empty()) return cameras;
    }
    return {};
}

std::vector<SearchedImage> BenchView::searchedImages()
{
    osg::GraphicsContext& context = *_viewer.getCamera()->getGraphicsContext();
    context.makeCurrent();
    std::vector<SearchedImage> images;
    for (osg::Camera* camera :
         _method.mirror ? std::vector<osg::Camera*>{_bed.mirror.get()} : captureCameras())
        if (const osg::Texture2D* const windowZ = windowZTexture(*camera))
            images.push_back({readWindowZ(*context.getState(), *windowZ, *camera->getViewport()),
                              camera->getViewMatrix(), camera->getProjectionMatrix()});
    if (images.empty()) throw std::runtime_error("expected a capture in the frame, got none");
    return images;
}

void BenchView::watchImages()
{
    auto& renderer = dynamic_cast<osgViewer::Renderer&>(*_viewer.getCamera()->getRenderer());
    osgUtil::RenderStage& viewStage = *renderer.getSceneView(0)->getRenderStage();
    const auto isTrace = [](const osgUtil::RenderStage& stage)
    { return stage.getCamera()->getName() == LowResTrace::CAMERA_NAME; };
    const auto watch = [&](osgUtil::RenderStage& image)
    {
        if (isTrace(image))
            _clock->watchTrace(*image.getCamera());
        else
            _clock->watchImage(*image.getCamera());
        for (const auto& after : image.getPostRenderList())
            if (isTrace(*after.second))
                _clock->watchTrace(*after.second->getCamera());
            else
                _clock->watchPyramid(*after.second->getCamera());
    };
    for (const auto& before : viewStage.getPreRenderList())
        watch(*before.second);
    if (osgUtil::RenderStage* const copy = FrameCopy::stageIn(viewStage)) watch(*copy);
}

FrameTime BenchView::time()
{
    const MethodScope scope(_method, _bed);
    // The first frame after another method makes the captures that it needs, anew where the other
    // had no use for them.
    if (_watchedMethod != _method.name)
    {
        frame();
        watchImages();
        _watchedMethod = _method.name;
    }
    _clock->start();
    frame();
    return _clock->read();
}
