#include "CaptureVisitor.h"

#include "../Transforms.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/Camera>

#include <algorithm>

using namespace osgWaterReflect;

namespace
{

// The StateSets that a view's cull has pushed so far, outermost first.
std::vector<const osg::StateSet*> pushedStateSets(osgUtil::CullVisitor& view)
{
    std::vector<const osg::StateSet*> stateSets;
    for (const osgUtil::StateGraph* graph = view.getCurrentStateGraph(); graph;
         graph = graph->_parent)
        if (graph->getStateSet()) stateSets.push_back(graph->getStateSet());
    std::reverse(stateSets.begin(), stateSets.end());
    return stateSets;
}

// Of these, how many belong to the view itself: through the one that osgUtil::SceneView keeps the
// frame's uniforms in, which it pushes last before it enters the scene.
std::size_t countOfView(const std::vector<const osg::StateSet*>& stateSets)
{
    for (std::size_t i = 0; i < stateSets.size(); ++i)
        if (stateSets[i]->getUniform("osg_FrameNumber") ||
            stateSets[i]->getUniform("osg_ViewMatrix"))
            return i + 1;
    return 0;
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

} // namespace

void CaptureVisitor::cull(osgUtil::CullVisitor& view, osgUtil::RenderStage& stage,
                          const osg::Matrixd& eyeFromViewEye, osg::RefMatrix& projection,
                          osg::Viewport& viewport)
{
    osgUtil::RenderStage& viewStage = *view.getCurrentRenderStage();
    osg::Camera& camera = *view.getCurrentCamera();

    // The path from the view's root to the innermost camera that renders on its own; empty where
    // that is the view's own camera.
    const osg::NodePath& path = view.getNodePath();
    const auto found = std::find(path.begin(), path.end(), &camera);
    const osg::NodePath cameraPath(path.begin(), found == path.end() ? path.begin() : found + 1);

    reset();
    _waters.clear();
    setFrameStamp(const_cast<osg::FrameStamp*>(view.getFrameStamp()));
    setTraversalNumber(view.getTraversalNumber());
    setTraversalMask(maskOfCamera(view));
    setTraversalMode(view.getTraversalMode());
    setNodeMaskOverride(view.getNodeMaskOverride());
    setDatabaseRequestHandler(view.getDatabaseRequestHandler());
    setImageRequestHandler(view.getImageRequestHandler());
    setCullSettings(view);
    setRenderInfo(view.getRenderInfo());

    _captureStateGraph->clean();
    stage.reset();
    setStateGraph(_captureStateGraph.get());
    setRenderStage(&stage);
    // A matrix object of its own: osg::State skips one that it has loaded last, but every stage
    // loads the identity behind its back, and the view's first light would be placed by that.
    const osg::ref_ptr<osg::RefMatrix> eyeFromWorld =
        new osg::RefMatrix(*viewStage.getInitialViewMatrix() * eyeFromViewEye);
    stage.setInitialViewMatrix(eyeFromWorld);
    stage.setColorMask(viewStage.getColorMask());
    stage.setClearColor(viewStage.getClearColor());
    stage.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    // Lights given from outside the scene: a head light, or those above a nested camera. They are
    // the stage's that the view inherits from; the scene's own are met again by this cull.
    osgUtil::PositionalStateContainer* inherited = viewStage.getInheritedPositionalStateContainer();
    if (inherited)
    {
        stage.setInheritedPositionalStateContainer(inherited);
        stage.setInheritedPositionalStateContainerMatrix(
            viewStage.getInheritedPositionalStateContainerMatrix() * eyeFromViewEye);
    }
    else
    {
        stage.setInheritedPositionalStateContainer(viewStage.getPositionalStateContainer());
        stage.setInheritedPositionalStateContainerMatrix(eyeFromViewEye);
    }

    // State from outside the captured scene. The water's own and that of the nodes between is
    // left out: it is not above the rest of the scene.
    std::vector<const osg::StateSet*> stateSets = pushedStateSets(view);
    stateSets.resize(countOfView(stateSets));
    for (const osg::Node* node : cameraPath)
        if (node->getStateSet()) stateSets.push_back(node->getStateSet());
    // Views and cameras keep their viewport in their StateSet too; the stage has another.
    _stageState->setAttribute(stage.getViewport());
    tellShaders(*eyeFromWorld, !eyeFromViewEye.isIdentity());
    stateSets.push_back(_stageState.get());
    for (const osg::StateSet* stateSet : stateSets)
        pushStateSet(stateSet);
    for (osg::Node* node : cameraPath)
        pushOntoNodePath(node);

    pushViewport(&viewport);
    pushProjectionMatrix(&projection);
    pushReferenceViewPoint(view.getReferenceViewPoint() * eyeFromViewEye);
    pushModelViewMatrix(eyeFromWorld, osg::Transform::RELATIVE_RF);

    if (osg::Callback* callback = camera.getCullCallback())
        callback->run(&camera, this);
    else
        traverse(camera);

    popModelViewMatrix();
    popReferenceViewPoint();
    popProjectionMatrix();
    popViewport();
    for (std::size_t i = 0; i < cameraPath.size(); ++i)
        popFromNodePath();
    for (std::size_t i = 0; i < stateSets.size(); ++i)
        popStateSet();
}

void CaptureVisitor::finish(osgUtil::RenderStage& stage)
{
    stage.sort();
    _captureStateGraph->prune();
}

void CaptureVisitor::meet(const WaterSurface& water,
                          const std::vector<osg::ref_ptr<StillWater>>& sheets)
{
    _waters.push_back({&water, &sheets, fromOsg(*getModelViewMatrix()), water.getReflection()});
}

// The view hands its matrices to shaders of the scene, which are to know of another eye.
void CaptureVisitor::tellShaders(const osg::Matrixd& eyeFromWorld, bool anotherEye)
{
    const auto tell = [&](const char* name, const osg::Matrixd& matrix)
    {
        _stageState->removeUniform(name);
        if (anotherEye) _stageState->addUniform(new osg::Uniform(name, osg::Matrixf(matrix)));
    };
    tell("osg_ViewMatrix", eyeFromWorld);
    tell("osg_ViewMatrixInverse", osg::Matrixd::inverse(eyeFromWorld));
}

// Cameras of the scene that render on their own have been, or will be, culled by the view: a
// texture rendered once a frame serves both, and a head-up display is not part of the scene.
void CaptureVisitor::apply(osg::Camera& camera)
{
    const osg::NodePath& path = getNodePath();
    const bool inScene = path.size() > 1 && path[path.size() - 2]->asGroup() &&
                         path[path.size() - 2]->asGroup()->containsNode(&camera);
    const bool inViewScene = path.size() == 1; // a child of the view's own camera
    const bool ownStage = camera.getRenderOrder() != osg::Camera::NESTED_RENDER;
    if (ownStage && (inScene || inViewScene || camera.getRenderOrder() == osg::Camera::POST_RENDER))
        return;
    osgUtil::CullVisitor::apply(camera);
}
