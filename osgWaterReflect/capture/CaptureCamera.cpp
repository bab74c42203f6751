#include "CaptureCamera.h"

#include <osg/GraphicsContext>
#include <osg/RenderInfo>
#include <osg/UserDataContainer>
#include <osg/View>

using namespace osgWaterReflect;

class CaptureCamera::BeginDraw : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override
    {
        static_cast<CaptureCamera*>(renderInfo.getCurrentCamera())
            ->belongTo(renderInfo.getView(), renderInfo.getState()->getGraphicsContext());
    }
};

class CaptureCamera::EndDraw : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override
    {
        static_cast<CaptureCamera*>(renderInfo.getCurrentCamera())->belongTo(nullptr, nullptr);
    }
};

CaptureCamera::CaptureCamera()
{
    setInitialDrawCallback(new BeginDraw);
    setFinalDrawCallback(new EndDraw);
}

void CaptureCamera::belongTo(osg::View* view, osg::GraphicsContext* context)
{
    _view = view;
    _graphicsContext = context;
}

CaptureCamera::CullScope::CullScope(CaptureCamera& camera, osg::Camera& viewCamera) :
    _camera(camera), _viewport(camera.getViewport())
{
    _camera.belongTo(viewCamera.getView(), viewCamera.getGraphicsContext());
    _camera._viewport = viewCamera.getViewport();
    _camera.setRenderer(viewCamera.getRenderer());
    _camera.setUserDataContainer(viewCamera.getUserDataContainer());
}

CaptureCamera::CullScope::~CullScope()
{
    _camera.belongTo(nullptr, nullptr);
    _camera._viewport = _viewport;
    _camera.setRenderer(nullptr);
    _camera.setUserDataContainer(nullptr);
}
