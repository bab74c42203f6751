#ifndef OSGWATERREFLECT_TESTS_SUPPORT_KEEPPICTURES_H
#define OSGWATERREFLECT_TESTS_SUPPORT_KEEPPICTURES_H

#include <osg/Camera>
#include <osg/Image>

#include <vector>

/// Keeps each frame of a window's camera, in the thread that draws it: its final draw callback. To
/// be looked at when that thread has stopped.
class KeepPictures : public osg::Camera::DrawCallback
{
public:
    /// [pixels] Of the window.
    KeepPictures(int width, int height) : _width(width), _height(height) {}

    void operator()(osg::RenderInfo&) const override
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(_width, _height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        glReadBuffer(GL_FRONT);
        glReadPixels(0, 0, _width, _height, GL_RGBA, GL_UNSIGNED_BYTE, image->data());
        if (glGetError() != GL_NO_ERROR) ++errors;
        pictures.push_back(image);
    }

    mutable std::vector<osg::ref_ptr<osg::Image>> pictures;
    mutable int errors = 0; ///< of OpenGL

private:
    const int _width;
    const int _height;
};

#endif
