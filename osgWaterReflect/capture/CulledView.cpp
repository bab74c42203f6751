#include "CulledView.h"

#include "../Transforms.h"

#include <osg/Camera>
#include <osg/Transform>

#include <algorithm>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

// Of the StateSets that a view's cull has pushed so far, those that belong to the view itself,
// outermost first: all up to the one that osgUtil::SceneView keeps the frame's uniforms in, which
// it pushes last before it enters the scene.
void findViewStateSets(osgUtil::CullVisitor& view, std::vector<const osg::StateSet*>& stateSets)
{
    stateSets.clear();
    for (const osgUtil::StateGraph* graph = view.getCurrentStateGraph(); graph;
         graph = graph->_parent)
        if (graph->getStateSet()) stateSets.push_back(graph->getStateSet());
    std::reverse(stateSets.begin(), stateSets.end());
    const auto frame = std::find_if(stateSets.begin(), stateSets.end(),
                                    [](const osg::StateSet* stateSet) {
                                        return stateSet->getUniform("osg_FrameNumber") ||
                                               stateSet->getUniform("osg_ViewMatrix");
                                    });
    stateSets.erase(frame == stateSets.end() ? stateSets.begin() : frame + 1, stateSets.end());
}

// The traversal mask that the cull of the view's camera began with. What stands above the water may
// have narrowed it since (a shadowed scene shows receivers only); what an eye of a stereo view
// began with is the narrowest that holds what is left.
osg::Node::NodeMask maskOfCamera(const osgUtil::CullVisitor& view)
{
    const auto now = view.getTraversalMask();
    auto mask = ~osg::Node::NodeMask(0);
    for (auto candidate : {view.getCullMask(), view.getCullMaskLeft(), view.getCullMaskRight()})
        if ((candidate & now) == now) mask &= candidate;
    return mask;
}

bool hasMatricesOfItsOwn(const osg::Camera& camera)
{
    return camera.getRenderOrder() == osg::Camera::NESTED_RENDER &&
           (camera.getReferenceFrame() != osg::Transform::RELATIVE_RF ||
            !camera.getViewMatrix().isIdentity() || !camera.getProjectionMatrix().isIdentity());
}

} // namespace

osg::Camera& osgWaterReflect::sceneCameraOf(osgUtil::CullVisitor& view)
{
    osg::Camera& stageCamera = *view.getCurrentCamera();
    const osg::NodePath& path = view.getNodePath();
    for (auto node = path.rbegin(); node != path.rend() && *node != &stageCamera; ++node)
        if (osg::Camera* const camera = (*node)->asCamera())
            if (hasMatricesOfItsOwn(*camera)) return *camera;
    return stageCamera;
}

void CulledView::note(osgUtil::CullVisitor& view)
{
    visitor = &view;
    stage = view.getCurrentRenderStage();
    stageCamera = view.getCurrentCamera();
    camera = &sceneCameraOf(view);

    const osg::NodePath& path = view.getNodePath();
    const auto found = std::find(path.begin(), path.end(), camera);
    cameraPath.assign(path.begin(), found == path.end() ? path.begin() : found + 1);
    findViewStateSets(view, stateSets);
    for (const osg::Node* node : cameraPath)
        if (node->getStateSet()) stateSets.push_back(node->getStateSet());

    traversalMask = maskOfCamera(view);
    cullSettings.setCullSettings(view);
    referenceViewPoint = view.getReferenceViewPoint();
    viewport = view.getViewport();
    eyeFromWorld = *stage->getInitialViewMatrix();
    if (isNested())
    {
        const auto stageEnd = std::find(path.begin(), path.end(), stageCamera);
        for (auto node = stageEnd == path.end() ? path.begin() : stageEnd + 1; node != found + 1;
             ++node)
            if (const osg::Transform* const transform = (*node)->asTransform())
                transform->computeLocalToWorldMatrix(eyeFromWorld, &view);
    }
    fittedProjection = view.getProjectionMatrix();
    clipFromEye = fromOsg(*fittedProjection);
    frameNumber = view.getTraversalNumber();
}

void CulledView::forget()
{
    fittedProjection = nullptr;
    cullSettings.setClampProjectionMatrixCallback(nullptr);
}

glm::ivec2 CulledView::viewportSize() const
{
    return {std::ceil(viewport->width()), std::ceil(viewport->height())};
}
