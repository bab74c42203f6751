#ifndef OSGWATERREFLECT_VIEWRECORD_H
#define OSGWATERREFLECT_VIEWRECORD_H

#include "capture/Capture.h"
#include "trace/SheetPass.h"

#include <osg/observer_ptr>

#include <list>

namespace osgWaterReflect
{

/// All that is held for the water of one view: a capture for each of its cameras, a pass for each
/// sheet of water.
///
/// It is attached to the view's CullVisitor: it lives as long, and no other thread uses it. (A view
/// that draws one frame while it culls the next has two, and so has each eye in stereo.)
class ViewRecord : public osg::Object
{
public:
    ViewRecord() = default;
    explicit ViewRecord(osgUtil::CullVisitor& view) : _view(&view) {}
    ViewRecord(const ViewRecord& rhs, const osg::CopyOp& copyop) : osg::Object(rhs, copyop) {}
    META_Object(osgWaterReflect, ViewRecord)

    /// The view's record, made on first use.
    static ViewRecord& of(osgUtil::CullVisitor& view);

    /// Draws one sheet of the water that the view has come to in its traversal.
    void draw(const WaterSurface& water, const StillWater& sheet);

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

protected:
    ~ViewRecord() override = default;

private:
    struct CameraCapture
    {
        osg::observer_ptr<osg::Camera> camera;
        osg::ref_ptr<Capture> capture;
    };

    struct DrawnSheet
    {
        osg::observer_ptr<const WaterSurface> water;
        osg::observer_ptr<const StillWater> sheet;
        const Capture* capture = nullptr; // identity only
        unsigned int serial = 0;          // of the capture when it was drawn last
        osg::ref_ptr<SheetPass> pass;
    };

    Capture& captureFor(osg::Camera& camera);
    SheetPass& passFor(const WaterSurface& water, const StillWater& sheet, const Capture& capture);

    osgUtil::CullVisitor* _view = nullptr;
    std::list<CameraCapture> _captures;
    std::list<DrawnSheet> _sheets;
};

} // namespace osgWaterReflect

#endif
