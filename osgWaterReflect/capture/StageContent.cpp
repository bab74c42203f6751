#include "StageContent.h"

#include "../Transforms.h"

#include <osg/Depth>
#include <osgUtil/StateGraph>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;
using osgUtil::RenderBin;
using osgUtil::RenderLeaf;
using osgUtil::StateGraph;

namespace
{

template <typename Visit>
void forEachBin(RenderBin& bin, const Visit& visit)
{
    visit(bin);
    for (const auto& child : bin.getRenderBinList())
        forEachBin(*child.second, visit);
}

bool writesDepth(const StateGraph* graph)
{
    for (; graph; graph = graph->_parent)
    {
        const osg::StateSet* const stateSet = graph->getStateSet();
        if (!stateSet) continue;
        const auto* depth =
            dynamic_cast<const osg::Depth*>(stateSet->getAttribute(osg::StateAttribute::DEPTH));
        if (depth) return depth->getWriteMask();
    }
    return true;
}

NdcExtent extentOf(const RenderLeaf& leaf, const glm::dmat4& clipFromEye)
{
    return seenExtent(leaf.getDrawable()->getBoundingBox(),
                      clipFromEye * fromOsg(*leaf._modelview));
}

bool isBounded(const RenderLeaf& leaf)
{
    const osg::Drawable* const drawable = leaf.getDrawable();
    return leaf._modelview.valid() && drawable && drawable->getCullingActive() &&
           drawable->getBoundingBox().valid();
}

// The pyramid of what is seen within an extent, to tell at little cost, and for most leaves, that
// all of a leaf lies in it, or none: by a sphere around the leaf.
class Pyramid
{
public:
    Pyramid(const NdcExtent& extent, const glm::dmat4& clipFromEye)
    {
        const glm::dmat4 rows = glm::transpose(clipFromEye);
        addSide(rows[0] - extent.left * rows[3], extent.left);
        addSide(extent.right * rows[3] - rows[0], extent.right);
        addSide(rows[1] - extent.bottom * rows[3], extent.bottom);
        addSide(extent.top * rows[3] - rows[1], extent.top);
        addSide(rows[3], 0.0); // before the eye
    }

    bool holdsAllOf(const RenderLeaf& leaf) const
    {
        const Sphere sphere = sphereOf(leaf);
        for (int i = 0; i < _numSides; ++i)
            if (height(i, sphere) < sphere.radius) return false;
        return true;
    }

    bool holdsNoneOf(const RenderLeaf& leaf) const
    {
        const Sphere sphere = sphereOf(leaf);
        for (int i = 0; i < _numSides; ++i)
            if (height(i, sphere) < -sphere.radius) return true;
        return false;
    }

private:
    struct Sphere
    {
        osg::Vec3d centre; // in eye space
        double radius;
    };

    // A side at infinity is none.
    void addSide(const glm::dvec4& plane, double place)
    {
        if (!std::isfinite(place)) return;
        const double length = glm::length(glm::dvec3(plane));
        if (length > 0.0) _sides[_numSides++] = plane / length;
    }

    static Sphere sphereOf(const RenderLeaf& leaf)
    {
        const osg::BoundingBox& bound = leaf.getDrawable()->getBoundingBox();
        const osg::Matrix& m = *leaf._modelview;
        double squaredScale = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            squaredScale =
                std::max(squaredScale, m(axis, 0) * m(axis, 0) + m(axis, 1) * m(axis, 1) +
                                           m(axis, 2) * m(axis, 2));
        // Axes that are not perpendicular reach further together than the longest of them.
        const double skewed = 1.7320508;
        return {osg::Vec3d(bound.center()) * m,
                skewed * bound.radius() * std::sqrt(squaredScale) * (1.0 + 1e-6)};
    }

    double height(int side, const Sphere& sphere) const
    {
        const glm::dvec4& plane = _sides[side];
        return plane.x * sphere.centre.x() + plane.y * sphere.centre.y() +
               plane.z * sphere.centre.z() + plane.w;
    }

    glm::dvec4 _sides[5];
    int _numSides = 0;
};

// Leaves out what is bounded and refused.
template <typename IsRefused>
void leaveOut(const StageContent& content, const IsRefused& isRefused)
{
    const auto isLeftOut = [&](const osg::ref_ptr<RenderLeaf>& leaf)
    { return leaf->_projection == &content.projection && isBounded(*leaf) && isRefused(*leaf); };
    const auto reduce = [&](RenderBin& bin)
    {
        auto& graphs = bin.getStateGraphList();
        for (StateGraph* graph : graphs)
            graph->_leaves.erase(
                std::remove_if(graph->_leaves.begin(), graph->_leaves.end(), isLeftOut),
                graph->_leaves.end());
        graphs.erase(std::remove_if(graphs.begin(), graphs.end(),
                                    [](const StateGraph* graph) { return graph->_leaves.empty(); }),
                     graphs.end());
    };
    forEachBin(content.stage, reduce);
}

} // namespace

NdcExtent StageContent::seenThrough(const glm::dmat4& clipFromEye, bool skies,
                                    const NdcExtent& asked) const
{
    NdcExtent seen = NdcExtent::none();
    Pyramid known(seen, clipFromEye);
    bool all = false;
    const auto addLeaf = [&](const RenderLeaf& leaf)
    {
        if (leaf._projection != &projection) return;
        if (!seen.empty() && isBounded(leaf) && known.holdsAllOf(leaf)) return;
        if (leaf._modelview.valid() && leaf.getDrawable())
            seen = unite(seen, extentOf(leaf, clipFromEye));
        known = Pyramid(seen, clipFromEye);
        all = contains(seen, asked);
    };
    const auto add = [&](RenderBin& bin)
    {
        for (const StateGraph* graph : bin.getStateGraphList())
            if (!all && (skies || writesDepth(graph)))
                for (const auto& leaf : graph->_leaves)
                    if (!all) addLeaf(*leaf);
    };
    forEachBin(stage, add);
    return seen;
}

void StageContent::keepSeenThrough(const glm::dmat4& clipFromEye) const
{
    const Pyramid seen(NdcExtent(), clipFromEye);
    leaveOut(*this,
             [&](const RenderLeaf& leaf)
             {
                 return seen.holdsNoneOf(leaf) ||
                        (!seen.holdsAllOf(leaf) &&
                         intersect(extentOf(leaf, clipFromEye), NdcExtent()).empty());
             });
}

void StageContent::keepBeyond(const glm::dmat4& clipFromEye) const
{
    const Pyramid seen(NdcExtent(), clipFromEye);
    leaveOut(*this,
             [&](const RenderLeaf& leaf)
             {
                 return seen.holdsAllOf(leaf) ||
                        (!seen.holdsNoneOf(leaf) &&
                         contains(NdcExtent(), extentOf(leaf, clipFromEye)));
             });
}
