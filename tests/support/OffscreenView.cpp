#include "OffscreenView.h"

#include "Catch.h"

#include <osgWaterReflect/offscreen/OffscreenContext.h>

#include <osgDB/WriteFile>

#include <cmath>

namespace
{

// Remembers the first GL error after each frame, in the context that drew it.
class CheckErrors : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo&) const override
    {
        const GLenum error = glGetError();
        if (error != GL_NO_ERROR) lastError = error;
    }
    mutable GLenum lastError = GL_NO_ERROR;
};

} // namespace

OffscreenView::OffscreenView(int width, int height, Format format) :
    _width(width), _height(height), _image(new osg::Image)
{
    const bool isFloat = format == Format::RGBA32F;
    const GLenum type = isFloat ? GL_FLOAT : GL_UNSIGNED_BYTE;
    _image->allocateImage(width, height, 1, GL_RGBA, type);
    if (isFloat) _image->setInternalTextureFormat(GL_RGBA32F_ARB);

    _viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    _viewer.setKeyEventSetsDone(0);
    osg::Camera& c = camera();
    c.setGraphicsContext(osgWaterReflect::createOffscreenContext(width, height).get());
    c.setViewport(0, 0, width, height);
    c.setDrawBuffer(GL_FRONT);
    c.setReadBuffer(GL_FRONT);
    if (isFloat) c.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    c.attach(isFloat ? osg::Camera::COLOR_BUFFER0 : osg::Camera::COLOR_BUFFER, _image);
    c.setFinalDrawCallback(new CheckErrors);
    look(osg::Vec3d(0, -10, 2), osg::Vec3d(0, 0, 2));
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
    const auto* errors = dynamic_cast<CheckErrors*>(camera().getFinalDrawCallback());
    REQUIRE(errors);
    CHECK(errors->lastError == GL_NO_ERROR);
    return *_image;
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
