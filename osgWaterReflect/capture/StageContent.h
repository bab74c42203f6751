#ifndef OSGWATERREFLECT_CAPTURE_STAGECONTENT_H
#define OSGWATERREFLECT_CAPTURE_STAGECONTENT_H

#include "../band/NdcExtent.h"

#include <osg/Matrix>
#include <osgUtil/RenderBin>

namespace osgWaterReflect
{

/// What of a stage is drawn with a projection, after its cull and before it is sorted. Leaves
/// without a bound, without a matrix of their own (light points), or that are not to be culled may
/// be seen anywhere: they are never left out, and nobody knows how far they reach.
struct StageContent
{
    osgUtil::RenderBin& stage;
    const osg::RefMatrix& projection;

    /// Where it may be seen, through any projection from the same eye, as far as anybody asks.
    ///   skies  whether what writes no depth counts, too
    ///   asked  what lies beyond is not looked for
    NdcExtent seenThrough(const glm::dmat4& clipFromEye, bool skies, const NdcExtent& asked) const;

    /// Leaves out what cannot be seen through a projection from the same eye.
    void keepSeenThrough(const glm::dmat4& clipFromEye) const;

    /// Leaves out what is seen through one as a whole.
    void keepBeyond(const glm::dmat4& clipFromEye) const;
};

} // namespace osgWaterReflect

#endif
