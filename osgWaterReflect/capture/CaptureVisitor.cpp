#include "CaptureVisitor.h"

#include "CaptureCamera.h"
#include "UnsteadyShadows.h"

#include <osg/Camera>

using namespace osgWaterReflect;

void CaptureVisitor::cull(const CulledView& view, osgUtil::RenderStage& stage,
                          const osg::Matrixd& eyeFromViewEye, osg::RefMatrix& projection,
                          osg::Viewport& viewport, const SeenPyramid* shown)
{
    const osgUtil::RenderStage& viewStage = *view.stage;
    osgUtil::CullVisitor& visitor = *view.visitor;

    _shown = shown;
    reset();
    setFrameStamp(const_cast<osg::FrameStamp*>(visitor.getFrameStamp()));
    setTraversalNumber(visitor.getTraversalNumber());
    setTraversalMask(view.traversalMask);
    setTraversalMode(visitor.getTraversalMode());
    setNodeMaskOverride(visitor.getNodeMaskOverride());
    setDatabaseRequestHandler(visitor.getDatabaseRequestHandler());
    setImageRequestHandler(visitor.getImageRequestHandler());
    setCullSettings(view.cullSettings);
    setRenderInfo(visitor.getRenderInfo());

    _captureStateGraph->clean();
    stage.reset();
    setStateGraph(_captureStateGraph.get());
    setRenderStage(&stage);
    auto& ownCamera = static_cast<CaptureCamera&>(*stage.getCamera());
    const CaptureCamera::CullScope scope(ownCamera, *view.stageCamera);
    // A matrix object of its own: osg::State skips one that it has loaded last, but every stage
    // loads the identity behind its back, and the view's first light would be placed by that.
    const osg::ref_ptr<osg::RefMatrix> eyeFromWorld =
        new osg::RefMatrix(view.eyeFromWorld * eyeFromViewEye);
    stage.setInitialViewMatrix(eyeFromWorld);
    ownCamera.setViewMatrix(*eyeFromWorld);
    ownCamera.setProjectionMatrix(projection);
    stage.setColorMask(const_cast<osg::ColorMask*>(viewStage.getColorMask()));
    stage.setClearColor(viewStage.getClearColor());
    stage.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    inheritLights(view, stage, eyeFromViewEye);

    // State from outside the captured scene. The water's own and that of the nodes between is
    // left out: it is not above the rest of the scene. Views and cameras keep their viewport in
    // their StateSet too; the stage has another.
    for (const osg::StateSet* stateSet : view.stateSets)
        pushStateSet(stateSet);
    _stageState->setAttribute(stage.getViewport());
    tellShaders(*eyeFromWorld, view.isNested() || !eyeFromViewEye.isIdentity());
    pushStateSet(_stageState.get());
    for (osg::Node* node : view.cameraPath)
        pushOntoNodePath(node);

    pushViewport(&viewport);
    pushProjectionMatrix(&projection);
    pushReferenceViewPoint(view.referenceViewPoint * eyeFromViewEye);
    pushModelViewMatrix(eyeFromWorld, osg::Transform::RELATIVE_RF);

    if (osg::Callback* callback = view.camera->getCullCallback())
        callback->run(view.camera, this);
    else
        traverse(*view.camera);

    popModelViewMatrix();
    popReferenceViewPoint();
    popProjectionMatrix();
    popViewport();
    for (std::size_t i = 0; i < view.cameraPath.size(); ++i)
        popFromNodePath();
    for (std::size_t i = 0; i < view.stateSets.size() + 1; ++i)
        popStateSet();

    // Before anything that was culled is left out, or the branches of what is would be made anew in
    // each frame.
    _captureStateGraph->prune();
}

// Lights given from outside the scene: a head light, or those above a nested camera. The scene's
// own are met again by this cull.
void CaptureVisitor::inheritLights(const CulledView& view, osgUtil::RenderStage& stage,
                                   const osg::Matrixd& eyeFromViewEye)
{
    osgUtil::RenderStage& viewStage = *view.stage;
    osgUtil::PositionalStateContainer* const inherited =
        viewStage.getInheritedPositionalStateContainer();
    if (view.isNested())
    {
        stage.setInheritedPositionalStateContainer(viewStage.getPositionalStateContainer());
        stage.setInheritedPositionalStateContainerMatrix(
            osg::Matrixd::inverse(*viewStage.getInitialViewMatrix()) * view.eyeFromWorld *
            eyeFromViewEye);
    }
    else if (inherited)
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

// Whether all of it lies in what is shown. What must be met wherever it lies, such as lights, is
// not culled by OSG either, nor is what is above.
bool CaptureVisitor::isShown(const osg::Node& node)
{
    if (!_shown || !node.isCullingActive()) return false;
    const osg::BoundingSphere& bound = node.getBound();
    if (!bound.valid()) return false;
    return _shown->holdsAllOf(EyeSphere(bound.center(), bound.radius(), *getModelViewMatrix()));
}

void CaptureVisitor::apply(osg::Group& group)
{
    const std::string unsteady = unsteadyShadowsOf(group);
    if (!unsteady.empty()) _unsteadyShadows = unsteady;
    if (isShown(group)) return;
    osgUtil::CullVisitor::apply(group);
}

// OSG takes all planes of the frustum into each transform's space, and that is half of what a cull
// of many of them costs; where the transform lies within the frustum none is needed any more.
void CaptureVisitor::apply(osg::Transform& transform)
{
    if (isShown(transform) || isCulled(transform)) return;
    // Stacks that grow meanwhile move what they hold: it is asked for anew.
    const auto current = [&]() -> osg::Polytope& { return getCurrentCullingSet().getFrustum(); };
    const auto whole = [&]() -> osg::Polytope&
    { return getProjectionCullingStack().back().getFrustum(); };
    const bool isWithin = transform.isCullingActive() && transform.getBound().valid() &&
                          (current().getCurrentMask() == 0 || current().getResultMask() == 0);
    current().setResultMask(isWithin ? 0 : current().getCurrentMask());
    current().pushCurrentMask();
    whole().setResultMask(isWithin ? 0 : whole().getCurrentMask());
    whole().pushCurrentMask();
    osgUtil::CullVisitor::apply(transform);
    whole().popCurrentMask();
    current().popCurrentMask();
}

bool CaptureVisitor::isFitted() const
{
    return getCalculatedFarPlane() >= getCalculatedNearPlane();
}

void CaptureVisitor::apply(osg::Drawable& drawable)
{
    if (!isShown(drawable)) osgUtil::CullVisitor::apply(drawable);
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
