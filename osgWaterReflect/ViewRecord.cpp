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
    beginCull(entry, view);
    const auto settingsOf = [&](const WaterSurface& met) { return entry.settings.of(view, met); };
    const ReflectionSettings settings = settingsOf(water);
    const auto take = [&](const CaptureEye& eye) -> Searched
    {
        const Taken& taken = takenFrom(entry, eye);
        taken.capture->require(view, eye, settingsOf);
        if (settings.search != Search::HIERARCHICAL) return {*taken.capture, nullptr};
        taken.pyramid->require(*taken.capture);
        return {*taken.capture, taken.pyramid.get()};
    };
    std::vector<Searched> searched;
    bool mirror =
        settings.capture == CaptureKind::MIRROR || settings.capture == CaptureKind::VIEW_AND_MIRROR;
    if (settings.capture != CaptureKind::MIRROR)
    {
        searched.push_back(take(viewEye(view)));
        if (ViewSettings::bandDecides(water) && searched[0].capture.bandServes()) mirror = false;
    }
    if (mirror) searched.push_back(take(mirroredEye(view, water, sheet)));
    passFor(entry, water, sheet).draw(view, searched, *entry.trace, water, sheet, settings);
    dropSheetsGone(entry);
}

// When others have been drawn: they share programs, which would go with the last to hold them.
void ViewRecord::dropSheetsGone(CameraCapture& entry)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    entry.sheets.remove_if([](const DrawnSheet& drawn)
                           { return !drawn.water.valid() || !drawn.sheet.valid(); });
}

// The first water that a cull comes to finds none of the captures arranged. What the cull before
// had no use for goes.
void ViewRecord::beginCull(CameraCapture& entry, osgUtil::CullVisitor& view)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    if (std::any_of(entry.taken.begin(), entry.taken.end(),
                    [&](const Taken& taken) { return taken.capture->isArranged(view); }))
        return;
    entry.taken.remove_if([&](const Taken& taken) { return taken.cull != entry.cull; });
    ++entry.cull;
    entry.settings.begin();
    entry.trace->begin();
}

// What this cull has taken already from that eye, or else what an earlier one took from any.
ViewRecord::Taken& ViewRecord::takenFrom(CameraCapture& entry, const CaptureEye& eye)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    auto& all = entry.taken;
    const auto now =
        std::find_if(all.begin(), all.end(),
                     [&](const Taken& taken)
                     { return taken.cull == entry.cull && serveTogether(taken.eye, eye); });
    if (now != all.end()) return *now;
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const Taken& taken) { return taken.cull != entry.cull; });
    if (found == all.end()) found = all.insert(found, {eye, new Capture, new Pyramid});
    found->eye = eye;
    found->cull = entry.cull;
    return *found;
}

ViewRecord::CameraCapture& ViewRecord::captureFor(osg::Camera& camera)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    _captures.remove_if([](const CameraCapture& entry) { return !entry.camera.valid(); });
    for (CameraCapture& entry : _captures)
        if (entry.camera == &camera) return entry;
    _captures.push_back({&camera, {}, new TracePass, {}, {}});
    return _captures.back();
}

// Where one sheet is met several times in a cull (its node has several parents), each has a pass of
// its own: one that has been used in this cull already is left alone.
SheetPass& ViewRecord::passFor(CameraCapture& entry, const WaterSurface& water,
                               const StillWater& sheet)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    auto drawn = std::find_if(entry.sheets.begin(), entry.sheets.end(),
                              [&](const DrawnSheet& candidate)
                              {
                                  return candidate.water == &water && candidate.sheet == &sheet &&
                                         candidate.sheet.valid() && candidate.cull != entry.cull;
                              });
    if (drawn == entry.sheets.end())
        drawn = entry.sheets.insert(drawn, {&water, &sheet, entry.cull, false, new SheetPass});
    drawn->cull = entry.cull;
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
    for (const Taken& taken : entry.taken)
    {
        taken.capture->releaseGLObjects(state);
        taken.pyramid->releaseGLObjects(state);
    }
    entry.trace->releaseGLObjects(state);
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
        for (const Taken& taken : entry.taken)
        {
            taken.capture->resizeGLObjectBuffers(maxSize);
            taken.pyramid->resizeGLObjectBuffers(maxSize);
        }
        entry.trace->resizeGLObjectBuffers(maxSize);
        for (DrawnSheet& drawn : entry.sheets)
            drawn.pass->resizeGLObjectBuffers(maxSize);
    }
}

std::size_t ViewRecord::numCaptures() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    std::size_t count = 0;
    for (const CameraCapture& entry : _captures)
        count += entry.taken.size();
    return count;
}

std::size_t ViewRecord::numPasses() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    std::size_t count = 0;
    for (const CameraCapture& entry : _captures)
        count += entry.sheets.size();
    return count;
}
