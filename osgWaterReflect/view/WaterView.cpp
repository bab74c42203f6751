#include "WaterView.h"

#include "../Transforms.h"
#include "../capture/UnsteadyShadows.h"
#include "../surface/EyeSide.h"
#include "StatusBoard.h"

#include <osg/Notify>
#include <osgUtil/RenderBin>

#include <algorithm>
#include <climits>

using namespace osgWaterReflect;

namespace
{

// Of the bin that tells when a view's cull is over: the last that is sorted.
const int LAST_BIN = INT_MAX;

void sayCopied(const std::string& technique)
{
    static std::once_flag said;
    std::call_once(said,
                   [&]
                   {
                       OSG_NOTICE << "osgWaterReflect: " << technique
                                  << " has other shadows each time a scene is drawn. Water with "
                                     "CaptureKind::AUTOMATIC reflects the frame itself there, "
                                     "without a guard band."
                                  << std::endl;
                   });
}

WaterStatus::Image statusOf(CaptureKind kind, const CaptureSize& size, bool cells)
{
    WaterStatus::Image image;
    image.kind = kind;
    image.width = size.whole().x;
    image.height = size.whole().y;
    image.bandLeft = size.band.left;
    image.bandRight = size.band.right;
    image.bandBottom = size.band.bottom;
    image.bandTop = size.band.top;
    image.depthCells = cells;
    return image;
}

// Stages of the library's own that are drawn with a view's.
int numPasses(osgUtil::RenderStage& stage)
{
    int count = 0;
    const auto addIfOurs = [&](osgUtil::RenderStage& other)
    {
        const osg::Camera* const camera = other.getCamera();
        const bool ours = camera && camera->getName().rfind("osgWaterReflect ", 0) == 0;
        if (ours) count += 1 + numPasses(other);
    };
    for (const auto& before : stage.getPreRenderList())
        addIfOurs(*before.second);
    for (const auto& after : stage.getPostRenderList())
        addIfOurs(*after.second);
    if (osgUtil::RenderStage* const copy = FrameCopy::stageIn(stage)) addIfOurs(*copy);
    return count;
}

} // namespace

// OSG sorts a stage's bins when the cull of its view is over: then all water in view is known, and
// near and far have been fitted.
class WaterView::WhenCulled : public osgUtil::RenderBin::SortCallback
{
public:
    WhenCulled(WaterView& view, SortCallback* before) : _view(&view), _before(before) {}

    void sortImplementation(osgUtil::RenderBin* bin) override
    {
        if (_before)
            _before->sortImplementation(bin);
        else
            bin->sortImplementation();
        _view->finish();
    }

    /// Whether a view is told by a callback, or one that it hands on to.
    static bool tells(const WaterView& view, SortCallback* callback)
    {
        const auto* const ours = dynamic_cast<WhenCulled*>(callback);
        return ours && (ours->_view == &view || tells(view, ours->_before.get()));
    }

private:
    const osg::ref_ptr<WaterView> _view;
    const osg::ref_ptr<SortCallback> _before;
};

WaterView::WaterView(osg::Camera& sceneCamera, osg::Camera& stageCamera,
                     const std::function<double()>& clock) :
    _sceneCamera(&sceneCamera),
    _stageCamera(&stageCamera), _clock(clock), _trace(new LowResTrace)
{
}

bool WaterView::isOf(const osg::Camera& sceneCamera, const osg::Camera& stageCamera) const
{
    return _sceneCamera == &sceneCamera && _stageCamera == &stageCamera;
}

void WaterView::enrol(osgUtil::CullVisitor& view, const EnrolledSheet& enrolled)
{
    if (!isEnrolling(*view.getCurrentRenderStage())) begin(view);
    VisibleSheet visible;
    static_cast<EnrolledSheet&>(visible) = enrolled;
    visible.eyeFromSurface =
        fromOsg(*view.getModelViewMatrix()) * enrolled.sheet->localFromSurface();
    visible.eyeAbove = isEyeAbove(visible.eyeFromSurface, _view.clipFromEye, enrolled.waves.get(),
                                  enrolled.bounds->amplitude);
    visible.draw = drawFor(*enrolled.water, *enrolled.sheet);
    visible.draw->enrol(view, visible);
    _visible.push_back(visible);
}

// Bins are new in each frame; and in the same frame, where OSG culls a camera twice and keeps what
// it has met last.
bool WaterView::isEnrolling(osgUtil::RenderStage& stage) const
{
    const auto& bins = stage.getRenderBinList();
    const auto last = bins.find(LAST_BIN);
    return last != bins.end() && WhenCulled::tells(*this, last->second->getSortCallback());
}

void WaterView::begin(osgUtil::CullVisitor& view)
{
    _visible.clear();
    ++_cull;
    _view.note(view);
    osgUtil::RenderBin* const last = _view.stage->find_or_insert(LAST_BIN, "RenderBin");
    last->setSortCallback(new WhenCulled(*this, last->getSortCallback()));
}

// Where one sheet is met several times in a cull (its node has several parents), each is drawn by
// one of its own.
osg::ref_ptr<WaterDraw> WaterView::drawFor(const WaterSurface& water, const StillWater& sheet)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    auto held = std::find_if(_draws.begin(), _draws.end(),
                             [&](const HeldDraw& candidate)
                             {
                                 return candidate.water == &water && candidate.sheet == &sheet &&
                                        candidate.sheet.valid() && candidate.cull != _cull;
                             });
    if (held == _draws.end())
        held = _draws.insert(held, {&water, &sheet, new WaterDraw, _cull, false});
    held->cull = _cull;
    held->released = false;
    return held->draw;
}

void WaterView::finish()
{
    plan();
    capture();
    draw();
    report();
    _visible.clear();
    _view.forget();
    letGo();
}

void WaterView::plan()
{
    if (!_shadowsLookedFor) _unsteadyShadows = unsteadyShadowsBelow(*_view.camera);
    _shadowsLookedFor = true;
    if (!_unsteadyShadows.empty()) sayCopied(_unsteadyShadows);

    ViewFacts facts{_visible};
    facts.clipFromEye = _view.clipFromEye;
    facts.viewportSize = _view.viewportSize();
    facts.viewport = {_view.viewport->width(), _view.viewport->height()};
    facts.effectView.eyeFromWorld = fromOsg(_view.eyeFromWorld);
    facts.nested = _view.isNested();
    facts.redrawsAlike = _unsteadyShadows.empty();
    facts.accuracyStep = [this](double target, int numSteps)
    {
        if (!_pace) _pace = FramePace::of(*_view.camera);
        return _pace->step(_view.frameNumber, target, numSteps);
    };
    facts.cullScene = [this](EyeImage image, const GuardBandRequest& request)
    { return cullScene(image, request); };
    makePlan(facts, _plan);
}

NdcExtent WaterView::cullScene(EyeImage image, const GuardBandRequest& request)
{
    const NdcExtent possible = request.possible();
    if (image == EyeImage::DRAWN) use(_drawn);
    if (image == EyeImage::COPIED) use(_copied);
    // A frame without a band is copied as a whole.
    if (image == EyeImage::COPIED && contains(NdcExtent(), possible)) return NdcExtent();
    const bool drawn = image == EyeImage::DRAWN;
    CapturedScene& scene = drawn ? _drawn.capture->scene() : _copied.capture->scene();
    scene.cull(_view, viewEye(_view.clipFromEye), possible,
               drawn ? CapturedScene::Part::ALL : CapturedScene::Part::BEYOND_VIEW);
    if (!scene.unsteadyShadows().empty()) _unsteadyShadows = scene.unsteadyShadows();
    return request.adapts() ? scene.seenBeyondView(request.seesDrawnSky(), request.reflected())
                            : NdcExtent();
}

void WaterView::capture()
{
    if (_plan.eyeImage == EyeImage::DRAWN)
    {
        _drawn.capture->draw(_view, _plan.eyeSize);
        if (_plan.eyeCells) _drawn.cells->compute(*_drawn.capture);
        if (_plan.eyeSky) _drawn.sky->compute(*_drawn.capture, _plan.upEye);
    }
    if (_plan.eyeImage == EyeImage::COPIED)
    {
        _copied.capture->take(_view, _plan.eyeSize);
        if (_plan.eyeCells) _copied.cells->compute(*_copied.capture);
        if (_plan.eyeSky) _copied.sky->compute(*_copied.capture, _plan.upEye);
    }
    if (_mirrored.size() < _plan.mirrors.size())
    {
        const std::lock_guard<std::mutex> lock(_mutex);
        _mirrored.resize(_plan.mirrors.size());
    }
    for (std::size_t i = 0; i < _plan.mirrors.size(); ++i)
    {
        HeldCapture<MirroredCapture>& held = _mirrored[i];
        use(held);
        held.capture->draw(_view, _plan.mirrors[i].eye, _plan.mirrorSize, _plan.amplitude);
        const std::string& unsteady = held.capture->scene().unsteadyShadows();
        if (!unsteady.empty()) _unsteadyShadows = unsteady;
        if (_plan.mirrors[i].cells) held.cells->compute(*held.capture);
        if (_plan.mirrors[i].sky) held.sky->compute(*held.capture, _plan.upEye);
    }
}

void WaterView::draw()
{
    const bool traced = _plan.traceScale < 1.0;
    if (traced)
        _trace->begin(_view, _plan.traceScale);
    else
        _trace->clear();
    for (std::size_t i = 0; i < _visible.size(); ++i)
    {
        const ViewPlan::Sheet& sheet = _plan.sheets[i];
        const SearchedCapture eyeImage = _plan.eyeImage == EyeImage::DRAWN
                                             ? searched(_drawn, sheet, _plan.eyeSky)
                                             : searched(_copied, sheet, _plan.eyeSky);
        SearchedCapture images[2];
        int count = 0;
        if (sheet.searchesEyeImage()) images[count++] = eyeImage;
        if (sheet.mirror >= 0)
            images[count++] =
                searched(_mirrored[sheet.mirror], sheet, _plan.mirrors[sheet.mirror].sky);
        const Capture* const scene = sheet.looksAtScene ? eyeImage.capture : nullptr;
        _visible[i].draw->prepare(_view, _visible[i], sheet.settings, sheet.effects, images[0],
                                  images[1], scene, *_trace);
    }
    const bool copied = _plan.eyeImage == EyeImage::COPIED;
    if (traced) _trace->draw(_view, copied ? &_copied.capture->stage() : nullptr);
}

// Tells each water what was done for it.
void WaterView::report()
{
    _status.camera = _sceneCamera;
    _status.frameNumber = _view.frameNumber;
    _status.captureScale = _plan.captureScale;
    _status.traceScale = _plan.traceScale;
    _status.accuracyStep = _plan.accuracyStep;
    _status.passes = numPasses(*_view.stage);
    for (std::size_t i = 0; i < _visible.size(); ++i)
    {
        const ViewPlan::Sheet& sheet = _plan.sheets[i];
        _status.sheet = _visible[i].number;
        _status.search = sheet.settings.search;
        _status.program = _visible[i].draw->programName();
        _status.decisions = sheet.decisions;
        _status.images.clear();
        if (sheet.usesEyeImage())
            _status.images.push_back(
                statusOf(_plan.eyeImage == EyeImage::DRAWN ? CaptureKind::VIEW : CaptureKind::FRAME,
                         _plan.eyeSize, _plan.eyeCells));
        if (sheet.mirror >= 0)
            _status.images.push_back(
                statusOf(CaptureKind::MIRROR, _plan.mirrorSize, _plan.mirrors[sheet.mirror].cells));
        _visible[i].status->publish(_status);
    }
}

// After the draws, for those that go share programs, which would go with the last to hold them.
void WaterView::letGo()
{
    const std::lock_guard<std::mutex> lock(_mutex);
    _draws.remove_if([](const HeldDraw& held)
                     { return !held.water.valid() || !held.sheet.valid(); });
    const double now = _clock();
    forEachCapture(
        [&](auto& held)
        {
            if (held.released || now - held.lastUsed <= HOLD_TIME) return;
            // Let go of, not released: its programs are shared with what stays.
            held = {};
        });
}

template <typename Kind>
void WaterView::use(HeldCapture<Kind>& held)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!held.capture)
    {
        held.capture = new Kind;
        held.cells = new DepthCells;
        held.sky = new SkyImage;
    }
    held.lastUsed = _clock();
    held.released = false;
}

template <typename Visit>
void WaterView::forEachCapture(const Visit& visit)
{
    visit(_drawn);
    visit(_copied);
    for (HeldCapture<MirroredCapture>& held : _mirrored)
        visit(held);
}

template <typename Kind>
SearchedCapture WaterView::searched(const HeldCapture<Kind>& held, const ViewPlan::Sheet& sheet,
                                    bool sky) const
{
    const bool reads = sheet.settings.search == Search::HIERARCHICAL;
    return {held.capture.get(), reads ? held.cells.get() : nullptr, sky ? held.sky.get() : nullptr};
}

template <typename Visit>
void WaterView::forEachGLObjects(const Visit& visit) const
{
    const auto visitHeld = [&](const auto& held)
    {
        if (!held.capture) return;
        visit(*held.capture);
        visit(*held.cells);
        visit(*held.sky);
    };
    visitHeld(_drawn);
    visitHeld(_copied);
    for (const auto& held : _mirrored)
        visitHeld(held);
    visit(*_trace);
    for (const HeldDraw& held : _draws)
        visit(*held.draw);
}

void WaterView::release(const WaterSurface& water, osg::State* state)
{
    bool inUse = false;
    {
        const std::lock_guard<std::mutex> lock(_mutex);
        for (HeldDraw& held : _draws)
        {
            held.released = held.released || held.water == &water;
            inUse = inUse || (!held.released && held.water.valid());
        }
    }
    if (!inUse) releaseGLObjects(state);
}

void WaterView::releaseGLObjects(osg::State* state) const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    forEachGLObjects([&](const GLObjects& objects) { objects.releaseGLObjects(state); });
}

void WaterView::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard<std::mutex> lock(_mutex);
    forEachGLObjects([&](GLObjects& objects) { objects.resizeGLObjectBuffers(maxSize); });
}

std::size_t WaterView::numCaptures() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    std::size_t count = !_drawn.released + !_copied.released;
    for (const HeldCapture<MirroredCapture>& held : _mirrored)
        count += !held.released;
    return count;
}

std::size_t WaterView::numDraws() const
{
    const std::lock_guard<std::mutex> lock(_mutex);
    return _draws.size();
}
