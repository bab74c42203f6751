#include "ViewRecord.h"

#include <osg/UserDataContainer>

using namespace osgWaterReflect;

ViewRecord& ViewRecord::of(osgUtil::CullVisitor& view)
{
    // A cloned CullVisitor shares its original's container, so the record says whose it is.
    osg::UserDataContainer* container = view.getOrCreateUserDataContainer();
    for (unsigned int i = 0; i < container->getNumUserObjects(); ++i)
    {
        auto* record = dynamic_cast<ViewRecord*>(container->getUserObject(i));
        if (record && record->_view == &view) return *record;
    }
    osg::ref_ptr<ViewRecord> record = new ViewRecord(view);
    container->addUserObject(record);
    return *record;
}

void ViewRecord::draw(const WaterSurface& water, const StillWater& sheet)
{
    Capture& capture = captureFor(*_view->getCurrentCamera());
    capture.require(*_view);
    passFor(water, sheet, capture).draw(*_view, capture, water, sheet);
}

Capture& ViewRecord::captureFor(osg::Camera& camera)
{
    _captures.remove_if([](const CameraCapture& entry) { return !entry.camera.valid(); });
    for (CameraCapture& entry : _captures)
        if (entry.camera == &camera) return *entry.capture;
    _captures.push_back({&camera, new Capture});
    return *_captures.back().capture;
}

// Where one sheet is met several times in a cull (its node has several parents), each has a pass of
// its own: one that has been used in this cull already is left alone.
SheetPass& ViewRecord::passFor(const WaterSurface& water, const StillWater& sheet,
                               const Capture& capture)
{
    _sheets.remove_if([](const DrawnSheet& drawn)
                      { return !drawn.water.valid() || !drawn.sheet.valid(); });
    for (DrawnSheet& drawn : _sheets)
    {
        if (drawn.water != &water || drawn.sheet != &sheet || drawn.capture != &capture ||
            drawn.serial == capture.serial())
            continue;
        drawn.serial = capture.serial();
        return *drawn.pass;
    }
    _sheets.push_back({&water, &sheet, &capture, capture.serial(), new SheetPass});
    return *_sheets.back().pass;
}

void ViewRecord::releaseGLObjects(osg::State* state) const
{
    for (const CameraCapture& entry : _captures)
        entry.capture->releaseGLObjects(state);
    for (const DrawnSheet& drawn : _sheets)
        drawn.pass->releaseGLObjects(state);
}

void ViewRecord::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (CameraCapture& entry : _captures)
        entry.capture->resizeGLObjectBuffers(maxSize);
    for (DrawnSheet& drawn : _sheets)
        drawn.pass->resizeGLObjectBuffers(maxSize);
}
