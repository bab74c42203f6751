#include "StageContent.h"

#include "../Transforms.h"

#include <osg/Depth>
#include <osgUtil/StateGraph>

#include <algorithm>

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

// Drawables without a bound, or that are not to be culled, may be seen anywhere.
bool isBounded(const RenderLeaf& leaf)
{
    const osg::Drawable& drawable = *leaf.getDrawable();
    return drawable.getCullingActive() && drawable.getBoundingBox().valid();
}

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

NdcExtent StageContent::seenThrough(const glm::dmat4& clipFromEye, bool skies) const
{
    NdcExtent seen = NdcExtent::none();
    const auto add = [&](RenderBin& bin)
    {
        for (const StateGraph* graph : bin.getStateGraphList())
            if (skies || writesDepth(graph))
                for (const auto& leaf : graph->_leaves)
                    if (leaf->_projection == &projection)
                        seen = unite(seen, extentOf(*leaf, clipFromEye));
    };
    forEachBin(stage, add);
    return seen;
}

void StageContent::keepSeenThrough(const glm::dmat4& clipFromEye) const
{
    leaveOut(*this, [&](const RenderLeaf& leaf)
             { return intersect(extentOf(leaf, clipFromEye), NdcExtent()).empty(); });
}

void StageContent::keepBeyond(const glm::dmat4& clipFromEye) const
{
    leaveOut(*this, [&](const RenderLeaf& leaf)
             { return contains(NdcExtent(), extentOf(leaf, clipFromEye)); });
}
