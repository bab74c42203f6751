#include "OffscreenView.h"

#include "Catch.h"

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osgDB/WriteFile>
#include <osgViewer/Renderer>

#include <algorithm>
#include <cmath>

namespace
{

// Asks for a frame's GL error, in the context that drew it.
class AskForError : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo&) const override { error = glGetError(); }
    mutable GLenum error = GL_NO_ERROR;
};

} // namespace

OffscreenView::OffscreenView(int width, int height, Format format) : _width(width), _height(height)
{
    const bool isFloat = format == Format::RGBA32F;
    _viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    // OSG would keep every test's thread to the first processor, where tests run side by side.
    _viewer.setUseConfigureAffinity(false);
    _viewer.setKeyEventSetsDone(0);
    osg::Camera& c = camera();
    c.setGraphicsContext(osgWaterReflect::createOffscreenContext(width, height).get());
    c.setViewport(0, 0, width, height);
    c.setDrawBuffer(GL_FRONT);
    c.setReadBuffer(GL_FRONT);
    if (isFloat) c.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    attachImage(isFloat ? GL_FLOAT : GL_UNSIGNED_BYTE);
    c.setFinalDrawCallback(new AskForError);
    look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 2));
}

void OffscreenView::attachImage(GLenum type)
{
    const auto buffer = type == GL_FLOAT ? osg::Camera::COLOR_BUFFER0 : osg::Camera::COLOR_BUFFER;
    _image = new osg::Image;
    _image->allocateImage(_width, _height, 1, GL_RGBA, type);
    if (type == GL_FLOAT) _image->setInternalTextureFormat(GL_RGBA32F_ARB);
    camera().detach(buffer);
    camera().attach(buffer, _image);
}

void OffscreenView::resize(int width, int height)
{
    _width = width;
    _height = height;
    camera().setViewport(0, 0, width, height);
    if (width == 0 || height == 0) return;
    attachImage(GL_FLOAT);
    camera().dirtyAttachmentMap();
}

void OffscreenView::look(const osg::Vec3d& eye, const osg::Vec3d& centre, double fovyDegrees)
{
    camera().setViewMatrixAsLookAt(eye, centre, osg::Vec3d(0, 0, 1));
    camera().setProjectionMatrixAsPerspective(fovyDegrees, double(_width) / _height, 0.1, 1000.0);
}

const osg::Image& OffscreenView::render(osg::Node* scene, double time)
{
    if (_viewer.getSceneData() != scene) _viewer.setSceneData(scene);
    if (!_viewer.isRealized())
    {
        _viewer.realize();
        // OSG looks for errors by itself, and takes them away.
        camera().getGraphicsContext()->getState()->setCheckForGLErrors(
            osg::State::NEVER_CHECK_GL_ERRORS);
    }
    _viewer.frame(time);
    const auto* asked = dynamic_cast<AskForError*>(camera().getFinalDrawCallback());
    REQUIRE(asked);
    if (_width > 0 && _height > 0) CHECK(asked->error == GL_NO_ERROR);
    return *_image;
}

osgWaterReflect::ViewRecord& OffscreenView::record()
{
    auto* renderer = dynamic_cast<osgViewer::Renderer*>(camera().getRenderer());
    REQUIRE(renderer);
    return osgWaterReflect::ViewRecord::of(*renderer->getSceneView(0)->getCullVisitor());
}

osg::Vec4 pixel(const osg::Image& image, int x, int y)
{
    return image.getColor(x, y);
}

int countDifferent(const osg::Image& a, const osg::Image& b, double tolerance)
{
    REQUIRE(a.s() == b.s());
    REQUIRE(a.t() == b.t());
    int count = 0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const osg::Vec4 difference = a.getColor(x, y) - b.getColor(x, y);
            bool differs = false;
            for (int i = 0; i < 3; ++i)
                differs = differs || !(std::abs(difference[i]) <= tolerance);
            count += differs;
        }
    return count;
}

int countNotFinite(const osg::Image& image)
{
    if (image.s() == 0 || image.t() == 0) return 0; // of an empty view
    REQUIRE(image.getDataType() == GL_FLOAT);
    const float* const values = reinterpret_cast<const float*>(image.data());
    return static_cast<int>(std::count_if(values, values + 4 * image.s() * image.t(),
                                          [](float value) { return !std::isfinite(value); }));
}

osg::ref_ptr<osg::Image> copyOf(const osg::Image& image)
{
    return new osg::Image(image, osg::CopyOp::DEEP_COPY_ALL);
}

void writeImage(const osg::Image& image, const std::string& file)
{
    osg::ref_ptr<osg::Image> bytes = new osg::Image;
    bytes->allocateImage(image.s(), image.t(), 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
        {
            osg::Vec4 colour = image.getColor(x, y);
            for (int i = 0; i < 3; ++i)
                colour[i] = osg::clampBetween(colour[i], 0.0f, 1.0f);
            bytes->setColor(colour, x, y);
        }
    INFO("writing " << file);
    CHECK(osgDB::writeImageFile(*bytes, file));
}

void keep(const osg::Image& image, const std::string& name)
{
    writeImage(image, std::string(OSGWATERREFLECT_TEST_OUTPUT_DIRECTORY) + "/" + name + ".png");
}
