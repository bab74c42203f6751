#ifndef OSGWATERBENCH_CULLPAIR_H
#define OSGWATERBENCH_CULLPAIR_H

#include "../measures/ThreadMeter.h"
#include "../render/CullView.h"
#include "../scenes/CullScene.h"

namespace osgwaterbench
{

/// A field of boxes without and with water, culled one after the other in each frame.
class CullPair
{
public:
    using Waters = std::vector<osg::ref_ptr<osgWaterReflect::WaterSurface>>;

    CullPair(osg::Group& field, const Waters& waters, const glm::ivec2& size);

    /// Where both are seen from, and when [s].
    void prepare(const FieldEye& eye, double time);

    /// Each by a function of its own, so that a profiler can tell them apart.
    void cullDry();
    void cullWet();

private:
    CullView _dry;
    CullView _wet;
    double _time = 0.0;
};

} // namespace osgwaterbench

#endif
