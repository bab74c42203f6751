#ifndef OSGWATERREFLECT_VIEW_VIEWRECORD_H
#define OSGWATERREFLECT_VIEW_VIEWRECORD_H

#include "WaterView.h"

namespace osgWaterReflect
{

/// All that is held for the water that one CullVisitor meets: a WaterView for each of its cameras.
///
/// It is attached to the CullVisitor and lives as long. (A view that draws one frame while it culls
/// the next has two, and so has each eye in stereo.)
class ViewRecord : public osg::Object
{
public:
    ViewRecord();
    explicit ViewRecord(osgUtil::CullVisitor& view);
    ViewRecord(const ViewRecord& rhs, const osg::CopyOp& copyop);
    META_Object(osgWaterReflect, ViewRecord)

    /// The visitor's record, made on first use.
    static ViewRecord& of(osgUtil::CullVisitor& view);

    /// Whether water can be reflected for the camera that a visitor is in: not while it renders
    /// depth alone (a shadow map), nor into an empty viewport.
    static bool serves(osgUtil::CullVisitor& view);

    /// The water of the view that the visitor is in.
    WaterView& waterView(osgUtil::CullVisitor& view);

    /// To be called for each water that is released; see WaterView::release.
    void release(const WaterSurface& water, osg::State* state);

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

    /// What is held now, for those who look for leaks.
    std::size_t numCaptures() const;
    std::size_t numDraws() const;

    /// [s] monotonic, for tests to replace: tells how long captures have not been used.
    std::function<double()> clock;

protected:
    ~ViewRecord() override = default;

private:
    std::vector<osg::ref_ptr<WaterView>> views() const;

    osg::observer_ptr<osgUtil::CullVisitor> _view;
    mutable std::mutex _mutex; // of the list
    std::vector<osg::ref_ptr<WaterView>> _views;
};

} // namespace osgWaterReflect

#endif
