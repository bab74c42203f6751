#ifndef OSGWATERREFLECT_CAPTURE_STAGECONTENT_H
#define OSGWATERREFLECT_CAPTURE_STAGECONTENT_H

#include "NdcExtent.h"

#include <osg/Matrix>
#include <osgUtil/RenderBin>

namespace osgWaterReflect
{

/// What of a stage is drawn with a projection, after its cull and before it is sorted.
struct StageContent
{
    osgUtil::RenderBin& stage;
    const osg::RefMatrix& projection;

    /// Where it may be seen, through any projection from the same eye.
    ///   skies  whether what writes no depth counts, too
    NdcExtent seenThrough(const glm::dmat4& clipFromEye, bool skies) const;

    /// Leaves out what cannot be seen through a projection from the same eye.
    void keepSeenThrough(const glm::dmat4& clipFromEye) const;

    /// Leaves out what is seen through one as a whole.
    void keepBeyond(const glm::dmat4& clipFromEye) const;
};

} // namespace osgWaterReflect

#endif
