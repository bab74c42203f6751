#include "HarbourWindow.h"

#include "Scenes.h"

namespace
{

// Reads the window's pixels once all of a frame is drawn.
class Screenshot : public osg::GraphicsOperation
{
public:
    Screenshot() : osg::GraphicsOperation("Screenshot", true), image(new osg::Image)
    {
        image->allocateImage(HarbourWindow::WIDTH, HarbourWindow::HEIGHT, 1, GL_RGBA,
                             GL_UNSIGNED_BYTE);
    }
    void operator()(osg::GraphicsContext*) override
    {
        glReadBuffer(GL_FRONT);
        glReadPixels(0, 0, image->s(), image->t(), GL_RGBA, GL_UNSIGNED_BYTE, image->data());
    }
    osg::ref_ptr<osg::Image> image;
};

} // namespace

HarbourWindow::HarbourWindow() :
    OffscreenView(WIDTH, HEIGHT), captured(CapturedImages::of(camera()))
{
    look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<Screenshot> screenshot = new Screenshot;
    camera().getGraphicsContext()->add(screenshot);
    _pixels = screenshot->image;
}

const osg::Image& HarbourWindow::render(osg::Node* scene)
{
    OffscreenView::render(scene);
    return *_pixels;
}
