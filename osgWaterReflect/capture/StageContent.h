#ifndef OSGWATERREFLECT_CAPTURE_STAGECONTENT_H
#define OSGWATERREFLECT_CAPTURE_STAGECONTENT_H

#include "SeenPyramid.h"

#include <osgUtil/RenderBin>

#include <vector>

namespace osgWaterReflect
{

/// What of a stage is drawn with one projection, after its cull and before it is sorted. Leaves
/// without a bound, without a matrix of their own (light points), or that are not to be culled may
/// be seen anywhere: they are never left out, and nobody knows how far they reach.
///
/// Most leaves lie within the view as a whole, and need no second look.
class StageContent
{
public:
    /// Looks at each leaf once. Stage and projection outlive what is asked of it.
    ///   clipFromEye  of the view
    ///   keepsWithin  false: what lies within the view as a whole is going to be left out
    void look(osgUtil::RenderBin& stage, const osg::RefMatrix& projection,
              const glm::dmat4& clipFromEye, bool keepsWithin);

    /// Where what lies beyond the view may be seen, as far as anybody asks; none() where nothing
    /// does.
    ///   skies  whether what writes no depth counts, too
    ///   asked  what lies beyond is not looked for
    NdcExtent seenBeyondView(bool skies, const NdcExtent& asked) const;

    /// Leaves out what cannot be seen through another projection from the same eye, wider than the
    /// view.
    void keepSeenThrough(const glm::dmat4& clipFromEye);

private:
    // One that needs a second look.
    struct Leaf
    {
        const osgUtil::RenderLeaf* leaf;
        std::size_t number; // among all of the stage
        bool within;        // the view as a whole
        bool writesDepth;
        bool bounded;
        EyeSphere sphere; // where it is bounded
    };

    osgUtil::RenderBin* _stage = nullptr;
    glm::dmat4 _clipFromEye{1.0};
    std::vector<Leaf> _looked; // in the order of the stage
};

} // namespace osgWaterReflect

#endif
