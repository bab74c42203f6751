#ifndef OSGWATERREFLECT_TESTS_SUPPORT_OFFSCREENVIEW_H
#define OSGWATERREFLECT_TESTS_SUPPORT_OFFSCREENVIEW_H

#include <osgWaterReflect/view/ViewRecord.h>

#include <osg/Camera>
#include <osg/Image>
#include <osgViewer/Viewer>

#include <string>

/// A viewer without a display that renders a scene frame by frame and hands the pictures out.
/// Every frame checks glGetError: an error fails the running test, unless the view is empty, where
/// OSG itself raises one.
class OffscreenView
{
public:
    enum class Format
    {
        RGBA8,  ///< the context's own buffer
        RGBA32F ///< a frame buffer object: colours beyond [0, 1] and exact codes
    };

    OffscreenView(int width, int height, Format format = Format::RGBA8);

    osgViewer::Viewer& viewer() { return _viewer; }
    osg::Camera& camera() { return *_viewer.getCamera(); }

    /// Looks from an eye to a centre, z up. fovyDegrees is vertical.
    void look(const osg::Vec3d& eye, const osg::Vec3d& centre, double fovyDegrees = 46.0);

    /// Gives a view of RGBA32F another size [pixels]; none, too.
    void resize(int width, int height);

    /// Renders one frame at a simulation time [s]; the image stays valid until the next.
    const osg::Image& render(osg::Node* scene, double time = 0.0);

    /// What the view holds for water.
    osgWaterReflect::ViewRecord& record();

    int width() const { return _width; }
    int height() const { return _height; }

private:
    void attachImage(GLenum type);

    int _width;
    int _height;
    osg::ref_ptr<osg::Image> _image;
    osgViewer::Viewer _viewer;
};

/// Colour of a pixel, from the lower left corner.
osg::Vec4 pixel(const osg::Image& image, int x, int y);

/// Number of pixels whose colours differ by more than a tolerance in any channel but alpha.
int countDifferent(const osg::Image& a, const osg::Image& b, double tolerance = 0.0);

/// Number of channels that are NaN or infinite in a picture of RGBA32F.
int countNotFinite(const osg::Image& image);

/// A copy, for comparing with a later frame.
osg::ref_ptr<osg::Image> copyOf(const osg::Image& image);

/// Writes an image, its colours clamped to [0, 1], in 8 bits.
void writeImage(const osg::Image& image, const std::string& file);

/// Writes an image for a person to look at, to build/test-output/NAME.png.
void keep(const osg::Image& image, const std::string& name);

#endif
