#include "ViewRecord.h"

#include <osg/Timer>
#include <osg/UserDataContainer>

#include <algorithm>

using namespace osgWaterReflect;

ViewRecord::ViewRecord() : clock([] { return osg::Timer::instance()->time_s(); }) {}

ViewRecord::ViewRecord(osgUtil::CullVisitor& view) : ViewRecord()
{
    _view = &view;
}

ViewRecord::ViewRecord(const ViewRecord& rhs, const osg::CopyOp& copyop) :
    osg::Object(rhs, copyop), clock(rhs.clock)
{
}

ViewRecord& ViewRecord::of(osgUtil::CullVisitor& view)
{
    // A cloned CullVisitor shares its original's container, so the record says whose it is.
    osg::UserDataContainer* container = view.getOrCreateUserDataContainer();
    for (unsigned int i = container->getNumUserObjects(); i-- > 0;)
    {
        auto* record = dynamic_cast<ViewRecord*>(container->getUserObject(i));
        if (!record) continue;
        if (!record->_view.valid())
            container->removeUserObject(i);
        else if (record->_view == &view)
            return *record;
    }
    osg::ref_ptr<ViewRecord> record = new ViewRecord(view);
    container->addUserObject(record);
    return *record;
}

bool ViewRecord::serves(osgUtil::CullVisitor& view)
{
    const osg::Camera* camera = view.getCurrentCamera();
    const osg::Viewport* viewport = view.getCurrentRenderStage()->getViewport();
    if (!camera || !viewport || viewport->width() < 1.0 || viewport->height() < 1.0) return false;

    const auto& attachments = camera->getBufferAttachmentMap();
    const bool hasColour = std::any_of(attachments.begin(), attachments.end(),
                                       [](const auto& attachment)
                                       { return attachment.first >= osg::Camera::COLOR_BUFFER; });
    return attachments.empty() || hasColour;
}

WaterView& ViewRecord::waterView(osgUtil::CullVisitor& view)
{
    osg::Camera& sceneCamera = sceneCameraOf(view);
    osg::Camera& stageCamera = *view.getCurrentCamera();
    const std::lock_guard<std::mutex> lock(_mutex);
    _views.erase(std::remove_if(_views.begin(), _views.end(),
                                [](const auto& held) { return !held->isAlive(); }),
                 _views.end());
    for (const osg::ref_ptr<WaterView>& held : _views)
        if (held->isOf(sceneCamera, stageCamera)) return *held;
    _views.push_back(new WaterView(sceneCamera, stageCamera, clock));
    return *_views.back();
}

std::vector<osg::ref_ptr<WaterView>> ViewRecord::views() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    return _views;
}

void ViewRecord::release(const WaterSurface& water, osg::State* state)
{
    for (const osg::ref_ptr<WaterView>& view : views())
        view->release(water, state);
}

void ViewRecord::releaseGLObjects(osg::State* state) const
{
    for (const osg::ref_ptr<WaterView>& view : views())
        view->releaseGLObjects(state);
}

void ViewRecord::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (const osg::ref_ptr<WaterView>& view : views())
        view->resizeGLObjectBuffers(maxSize);
}

std::size_t ViewRecord::numCaptures() const
{
    std::size_t count = 0;
    for (const osg::ref_ptr<WaterView>& view : views())
        count += view->numCaptures();
    return count;
}

std::size_t ViewRecord::numDraws() const
{
    std::size_t count = 0;
    for (const osg::ref_ptr<WaterView>& view : views())
        count += view->numDraws();
    return count;
}
