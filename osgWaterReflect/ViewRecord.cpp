#include "ViewRecord.h"

#include <osg/UserDataContainer>

#include <algorithm>

using namespace osgWaterReflect;

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

void ViewRecord::draw(osgUtil::CullVisitor& view, const WaterSurface& water,
                      const StillWater& sheet)
{
    CameraCapture& entry = captureFor(*view.getCurrentCamera());
    entry.capture->require(view);
    const bool hierarchical = water.getReflection().search == Search::HIERARCHICAL;
    if (hierarchical) entry.pyramid->require(*entry.capture);
    const Searched searched = {*entry.capture, hierarchical ? entry.pyramid.get() : nullptr};
    passFor(entry, water, sheet).draw(view, searched, water, sheet);
}

ViewRecord::CameraCapture& ViewRecord::captureFor(osg::Camera& camera)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    _captures.remove_if([](const CameraCapture& entry) { return !entry.camera.valid(); });
    for (CameraCapture& entry : _captures)
        if (entry.camera == &camera) return entry;
    _captures.push_back({&camera, new Capture, new Pyramid, {}});
    return _captures.back();
}

// Where one sheet is met several times in a cull (its node has several parents), each has a pass of
// its own: one that has been used in this cull already is left alone.
SheetPass& ViewRecord::passFor(CameraCapture& entry, const WaterSurface& water,
                               const StillWater& sheet)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    const unsigned int serial = entry.capture->serial();
    entry.sheets.remove_if([](const DrawnSheet& drawn)
                           { return !drawn.water.valid() || !drawn.sheet.valid(); });
    auto drawn = std::find_if(entry.sheets.begin(), entry.sheets.end(),
                              [&](const DrawnSheet& candidate) {
                                  return candidate.water == &water && candidate.sheet == &sheet &&
                                         candidate.serial != serial;
                              });
    if (drawn == entry.sheets.end())
        drawn = entry.sheets.insert(drawn, {&water, &sheet, serial, false, new SheetPass});
    drawn->serial = serial;
    drawn->released = false;
    return *drawn->pass;
}

void ViewRecord::release(const WaterSurface& water, osg::State* state)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    for (CameraCapture& entry : _captures)
    {
        for (DrawnSheet& drawn : entry.sheets)
            drawn.released = drawn.released || drawn.water == &water;
        const bool inUse = std::any_of(entry.sheets.begin(), entry.sheets.end(),
                                       [](const DrawnSheet& drawn)
                                       { return !drawn.released && drawn.water.valid(); });
        if (!inUse) releaseGLObjects(entry, state);
    }
}

void ViewRecord::releaseGLObjects(const CameraCapture& entry, osg::State* state)
{
    entry.capture->releaseGLObjects(state);
    entry.pyramid->releaseGLObjects(state);
    for (const DrawnSheet& drawn : entry.sheets)
        drawn.pass->releaseGLObjects(state);
}

void ViewRecord::releaseGLObjects(osg::State* state) const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    for (const CameraCapture& entry : _captures)
        releaseGLObjects(entry, state);
}

void ViewRecord::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    for (CameraCapture& entry : _captures)
    {
        entry.capture->resizeGLObjectBuffers(maxSize);
        entry.pyramid->resizeGLObjectBuffers(maxSize);
        for (DrawnSheet& drawn : entry.sheets)
            drawn.pass->resizeGLObjectBuffers(maxSize);
    }
}

std::size_t ViewRecord::numCaptures() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    return _captures.size();
}

std::size_t ViewRecord::numPasses() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    std::size_t count = 0;
    for (const CameraCapture& entry : _captures)
        count += entry.sheets.size();
    return count;
}
