#ifndef OSGWATERREFLECT_PASSES_IMAGESTAGE_H
#define OSGWATERREFLECT_PASSES_IMAGESTAGE_H

#include <osg/Geometry>
#include <osg/StateSet>
#include <osgUtil/RenderStage>
#include <osgUtil/StateGraph>

namespace osgWaterReflect
{

/// A render stage that computes an image: all it draws is a triangle over its viewport, with a
/// StateSet of its own. What it renders to are the attachments of its camera.
class ImageStage : public osgUtil::RenderStage
{
public:
    ImageStage();

    osg::StateSet& stateSet() { return *_stateSet; }

    /// Makes it ready to be drawn once more: a stage drops what it draws with each frame.
    ///   x, y, width, height  [pixels] of its target
    void prepare(int x, int y, int width, int height);

    void releaseGLObjects(osg::State* state = nullptr) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

protected:
    ~ImageStage() override = default;

private:
    osg::ref_ptr<osg::StateSet> _stateSet;
    osg::ref_ptr<osg::Geometry> _triangle;
    osg::ref_ptr<osgUtil::StateGraph> _stateGraph;
};

} // namespace osgWaterReflect

#endif
