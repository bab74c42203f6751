#include "StageContent.h"

#include "../Transforms.h"

#include <osg/Depth>
#include <osgUtil/StateGraph>

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

EyeSphere sphereOf(const RenderLeaf& leaf)
{
    const osg::BoundingBox& bound = leaf.getDrawable()->getBoundingBox();
    return EyeSphere(bound.center(), bound.radius(), *leaf._modelview);
}

} // namespace

void StageContent::look(RenderBin& stage, const osg::RefMatrix& projection,
                        const glm::dmat4& clipFromEye, bool keepsWithin)
{
    _stage = &stage;
    _clipFromEye = clipFromEye;
    _looked.clear();
    const SeenPyramid view(NdcExtent(), clipFromEye);
    std::size_t number = 0;
    const auto lookAt = [&](const RenderLeaf& leaf, bool depth)
    {
        if (leaf._projection != &projection || !leaf._modelview.valid() || !leaf.getDrawable())
            return;
        const EyeSphere sphere = sphereOf(leaf);
        const bool bounded = isBounded(leaf);
        const bool within =
            bounded && (view.holdsAllOf(sphere) ||
                        (!keepsWithin && contains(NdcExtent(), extentOf(leaf, clipFromEye))));
        if (!within || !keepsWithin)
            _looked.push_back({&leaf, number, within, depth, bounded, sphere});
    };
    forEachBin(stage,
               [&](RenderBin& bin)
               {
                   for (const StateGraph* graph : bin.getStateGraphList())
                   {
                       const bool depth = writesDepth(graph);
                       for (const auto& leaf : graph->_leaves)
                       {
                           lookAt(*leaf, depth);
                           ++number;
                       }
                   }
               });
}

NdcExtent StageContent::seenBeyondView(bool skies, const NdcExtent& asked) const
{
    NdcExtent seen = NdcExtent::none();
    SeenPyramid known(NdcExtent(), _clipFromEye);
    for (const Leaf& looked : _looked)
    {
        if (looked.within || (!skies && !looked.writesDepth)) continue;
        if (looked.bounded && known.holdsAllOf(looked.sphere)) continue;
        seen = unite(seen, extentOf(*looked.leaf, _clipFromEye));
        known = SeenPyramid(unite(NdcExtent(), seen), _clipFromEye);
        if (contains(unite(NdcExtent(), seen), asked)) break;
    }
    return seen;
}

void StageContent::keepSeenThrough(const glm::dmat4& clipFromEye)
{
    const SeenPyramid wide(NdcExtent(), clipFromEye);
    const auto isSeen = [&](const Leaf& looked)
    {
        if (looked.within) return false;
        if (!looked.bounded || wide.holdsAllOf(looked.sphere)) return true;
        return !wide.holdsNoneOf(looked.sphere) &&
               !intersect(extentOf(*looked.leaf, clipFromEye), NdcExtent()).empty();
    };
    std::size_t number = 0;
    auto next = _looked.begin();
    const auto isKept = [&]
    {
        const bool isLooked = next != _looked.end() && next->number == number;
        ++number;
        return !isLooked || isSeen(*next++);
    };
    forEachBin(*_stage,
               [&](RenderBin& bin)
               {
                   auto& graphs = bin.getStateGraphList();
                   for (StateGraph* graph : graphs)
                   {
                       auto& leaves = graph->_leaves;
                       auto end = leaves.begin(); // of those that are kept
                       for (auto leaf = leaves.begin(); leaf != leaves.end(); ++leaf)
                           if (isKept() && end++ != leaf) std::prev(end)->swap(*leaf);
                       leaves.erase(end, leaves.end());
                   }
                   graphs.erase(std::remove_if(graphs.begin(), graphs.end(),
                                               [](const StateGraph* graph)
                                               { return graph->_leaves.empty(); }),
                                graphs.end());
               });
    _looked.clear();
}
