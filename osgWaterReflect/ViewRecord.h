#ifndef OSGWATERREFLECT_VIEWRECORD_H
#define OSGWATERREFLECT_VIEWRECORD_H

#include "capture/Capture.h"
#include "choice/ViewSettings.h"
#include "pyramid/Pyramid.h"
#include "trace/SheetPass.h"

#include <osg/observer_ptr>

#include <list>
#include <mutex>

namespace osgWaterReflect
{

/// All that is held for the water of one view: for each of its cameras the captures with their
/// pyramids, one of the camera's eye and one of that eye mirrored in each plane of water, as far as
/// the waters in view ask for them; and a pass for each sheet of water that the camera sees.
///
/// It is attached to the view's CullVisitor and lives as long. (A view that draws one frame while
/// it culls the next has two, and so has each eye in stereo.) Only that visitor's thread draws;
/// any thread may release.
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
    void draw(osgUtil::CullVisitor& view, const WaterSurface& water, const StillWater& sheet);

    /// To be called for each water that is released: releases what is held for a camera with the
    /// last of its waters, for they share captures and programs.
    void release(const WaterSurface& water, osg::State* state);

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

    /// What is held now, for those who look for leaks.
    std::size_t numCaptures() const;
    std::size_t numPasses() const;

protected:
    ~ViewRecord() override = default;

private:
    struct DrawnSheet
    {
        osg::observer_ptr<const WaterSurface> water;
        osg::observer_ptr<const StillWater> sheet;
        unsigned int cull = 0; // number of the cull that drew it last
        bool released = false; // since then
        osg::ref_ptr<SheetPass> pass;
    };

    struct Taken
    {
        CaptureEye eye;
        osg::ref_ptr<Capture> capture;
        osg::ref_ptr<Pyramid> pyramid; // its images are made when it is first required
        unsigned int cull = 0;         // number of the cull that took it last
    };

    struct CameraCapture
    {
        osg::observer_ptr<osg::Camera> camera;
        std::list<Taken> taken;
        osg::ref_ptr<TracePass> trace; // its image is made when some water asks for it
        std::list<DrawnSheet> sheets;
        ViewSettings settings;
        unsigned int cull = 0; // number of the cull that has come to some water last
    };

    static void releaseGLObjects(const CameraCapture& entry, osg::State* state);
    CameraCapture& captureFor(osg::Camera& camera);
    void beginCull(CameraCapture& entry, osgUtil::CullVisitor& view);
    Taken& takenFrom(CameraCapture& entry, const CaptureEye& eye);
    SheetPass& passFor(CameraCapture& entry, const WaterSurface& water, const StillWater& sheet);
    void dropSheetsGone(CameraCapture& entry);

    osg::observer_ptr<osgUtil::CullVisitor> _view;
    mutable std::mutex _mutex; // of the list and its entries' lists
    std::list<CameraCapture> _captures;
};

} // namespace osgWaterReflect

#endif
