#include "OffscreenContext.h"

using namespace osgWaterReflect;

OffscreenContext::OffscreenContext(int width, int height)
{
    _traits = new Traits;
    _traits->width = width;
    _traits->height = height;
    _traits->doubleBuffer = false;
    _traits->pbuffer = true;

    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(osg::GraphicsContext::createNewContextID());
}
