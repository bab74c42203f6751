#include <osgWaterReflect/WaterSurface>

#include "Check.h"
#include "Transforms.h"
#include "capture/CaptureVisitor.h"
#include "dynamics/WaterDynamics.h"
#include "surface/OutlineGeometry.h"
#include "surface/StillWater.h"
#include "view/StatusBoard.h"
#include "view/ViewRecord.h"

#include <osg/Geometry>
#include <osg/Notify>

#include <algorithm>
#include <atomic>

using namespace osgWaterReflect;

namespace
{

WaterSurface* createWater(osg::Geometry* shape)
{
    osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->addDrawable(shape);
    return water.release();
}

void sayNoSheet(const WaterSurface& water)
{
    static std::once_flag said;
    std::call_once(said,
                   [&]
                   {
                       refuse("WaterSurface::getSurfaceFromWorld", "a drawable with an area",
                              "none in \"" + water.getName() + "\"; it is taken to lie at z = 0");
                   });
}

bool expectDrawable(const char* member, const osg::Node* child)
{
    if (child && child->asDrawable()) return true;
    return refuse(member, "a drawable", child ? child->getCompoundClassName() : "null");
}

} // namespace

WaterSurface::WaterSurface() :
    _waveBounds(std::make_shared<WaveBounds>()), _dynamics(std::make_unique<WaterDynamics>()),
    _status(std::make_shared<StatusBoard>())
{
}

WaterSurface::WaterSurface(const WaterSurface& rhs, const osg::CopyOp& copyop) :
    osg::Geode(rhs, copyop), _reflection(rhs._reflection), _viewSettings(rhs._viewSettings),
    _optics(rhs._optics), _detail(rhs._detail), _waveBounds(rhs._waveBounds),
    _dynamics(std::make_unique<WaterDynamics>()),
    _sky(static_cast<osg::TextureCubeMap*>(copyop(rhs._sky.get()))), _debugView(rhs._debugView),
    _status(std::make_shared<StatusBoard>())
{
    takeWaves(static_cast<WaveModel*>(copyop(static_cast<osg::Object*>(rhs._waves.get()))));
}

WaterSurface::~WaterSurface() = default;

WaterSurface* WaterSurface::createRectangle(const osg::Vec3& centre, const osg::Vec3& lengthVec,
                                            const osg::Vec3& widthVec)
{
    const osg::ref_ptr<osg::Geometry> rectangle =
        createRectangleGeometry("WaterSurface::createRectangle", centre, lengthVec, widthVec);
    return rectangle ? createWater(rectangle) : nullptr;
}

WaterSurface* WaterSurface::createPolygon(const Outline& outline, const std::vector<Outline>& holes)
{
    const osg::ref_ptr<osg::Geometry> polygon =
        createPolygonGeometry("WaterSurface::createPolygon", outline, holes);
    return polygon ? createWater(polygon) : nullptr;
}

bool WaterSurface::addChild(osg::Node* child)
{
    return expectDrawable("WaterSurface::addChild", child) && osg::Geode::addChild(child);
}

bool WaterSurface::insertChild(unsigned int index, osg::Node* child)
{
    return expectDrawable("WaterSurface::insertChild", child) &&
           osg::Geode::insertChild(index, child);
}

bool WaterSurface::replaceChild(osg::Node* oldChild, osg::Node* newChild)
{
    return expectDrawable("WaterSurface::replaceChild", newChild) &&
           osg::Geode::replaceChild(oldChild, newChild);
}

bool WaterSurface::setChild(unsigned int index, osg::Node* child)
{
    return expectDrawable("WaterSurface::setChild", child) && osg::Geode::setChild(index, child);
}

bool WaterSurface::setReflection(const ReflectionSettings& settings)
{
    if (!settings.check()) return false;
    _reflection = settings;
    return true;
}

bool WaterSurface::setViewSettings(const ViewSettings& settings)
{
    if (!settings.check()) return false;
    _viewSettings = settings;
    return true;
}

bool WaterSurface::setOptics(const WaterOptics& optics)
{
    if (!optics.check()) return false;
    _optics = optics;
    return true;
}

bool WaterSurface::setDetail(const SurfaceDetail& detail)
{
    if (!detail.check()) return false;
    _detail = detail;
    return true;
}

// Only waves ask for the update traversal.
void WaterSurface::takeWaves(WaveModel* waves)
{
    if (waves && !_waves)
        setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    if (!waves && _waves)
        setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() - 1);
    _waves = waves;
    _dynamics->setWaves(waves);
}

// The bound is computed at once: so whatever changes a drawable afterwards is told of it anew, and
// its sheets are not taken for those of before.
void WaterSurface::setWaves(WaveModel* waves)
{
    takeWaves(waves);
    _waveBounds = std::make_shared<WaveBounds>(waves);
    _onlyWavesChange = _boundingSphereComputed;
    dirtyBound();
    if (_onlyWavesChange) getBound();
    _onlyWavesChange = false;
}

// Runs before any cull whenever a drawable's shape has changed: the place to take the sheets from
// the drawables.
osg::BoundingSphere WaterSurface::computeBound() const
{
    osg::BoundingSphere bound = osg::Geode::computeBound();
    if (!_onlyWavesChange)
    {
        const auto sheets = std::make_shared<Sheets>();
        for (unsigned int i = 0; i < getNumDrawables(); ++i)
        {
            const osg::Drawable* const drawable = getDrawable(i);
            if (!drawable) continue; // osg::Group's own addChild takes any node
            const auto own = StillWater::createSheets(const_cast<osg::Drawable&>(*drawable));
            sheets->insert(sheets->end(), own.begin(), own.end());
        }
        std::atomic_store(&_sheets, std::shared_ptr<const Sheets>(sheets));
    }
    if (_waves)
    {
        for (const osg::ref_ptr<StillWater>& sheet : *sheets())
            _bbox.expandBy(sheet->localBound(_waveBounds->amplitude));
        bound = osg::BoundingSphere(_bbox);
    }
    return bound;
}

std::shared_ptr<const WaterSurface::Sheets> WaterSurface::sheets() const
{
    static const auto none = std::make_shared<const Sheets>();
    const std::shared_ptr<const Sheets> sheets = std::atomic_load(&_sheets);
    return sheets ? sheets : none;
}

// Of a point in world space.
struct WaterSurface::WorldPlace
{
    glm::dmat4 worldFromSurface{1.0};
    osg::Vec2d place; // in surface space
};

WaterSurface::WorldPlace WaterSurface::placeUnder(const osg::Vec3d& worldPoint) const
{
    WorldPlace under;
    const osg::MatrixList worlds = getWorldMatrices();
    if (!worlds.empty()) under.worldFromSurface = fromOsg(worlds.front());
    const glm::dvec4 point(fromOsg(worldPoint), 1.0);
    const glm::dvec3 localPoint = glm::inverse(under.worldFromSurface) * point;

    getBound(); // the sheets are as of the last bound
    const std::shared_ptr<const Sheets> all = sheets();
    const StillWater* nearest = nullptr;
    double least = 0.0; // [local units^2]
    for (const osg::ref_ptr<StillWater>& sheet : *all)
    {
        const double distance = all->size() == 1 ? 0.0 : sheet->squaredDistance(localPoint);
        if (nearest && distance >= least) continue;
        nearest = sheet;
        least = distance;
    }
    if (nearest)
        under.worldFromSurface = under.worldFromSurface * nearest->localFromSurface();
    else
        sayNoSheet(*this);
    const glm::dvec3 surfacePoint = glm::inverse(under.worldFromSurface) * point;
    under.place.set(surfacePoint.x, surfacePoint.y);
    return under;
}

osg::Matrixd WaterSurface::getSurfaceFromWorld(const osg::Vec3d& worldPoint) const
{
    return toOsg(glm::inverse(placeUnder(worldPoint).worldFromSurface));
}

osg::Vec3d WaterSurface::getSurfacePoint(const osg::Vec3d& worldPoint, double time) const
{
    const WorldPlace under = placeUnder(worldPoint);
    const osg::ref_ptr<const WaveState> waves = _dynamics->at(time);
    const double height = waves ? waves->getHeight(under.place) : 0.0;
    const glm::dvec4 surfacePoint(under.place.x(), under.place.y(), height, 1.0);
    return toOsg(glm::dvec3(under.worldFromSurface * surfacePoint));
}

// A scale that is not the same in all directions lays the normal over, and the height with it.
double WaterSurface::getHeight(const osg::Vec3d& worldPoint, double time) const
{
    const WorldPlace under = placeUnder(worldPoint);
    const osg::ref_ptr<const WaveState> waves = _dynamics->at(time);
    if (!waves) return 0.0;
    const glm::dvec3 stillNormal = glm::normalize(normalMatrix(under.worldFromSurface)[2]);
    return waves->getHeight(under.place) *
           glm::dot(stillNormal, glm::dvec3(under.worldFromSurface[2]));
}

osg::Vec3d WaterSurface::getNormal(const osg::Vec3d& worldPoint, double time) const
{
    const WorldPlace under = placeUnder(worldPoint);
    const osg::ref_ptr<const WaveState> waves = _dynamics->at(time);
    const osg::Vec3d normal = waves ? waves->getNormal(under.place) : osg::Vec3d(0.0, 0.0, 1.0);
    return toOsg(glm::normalize(normalMatrix(under.worldFromSurface) * fromOsg(normal)));
}

void WaterSurface::traverse(osg::NodeVisitor& visitor)
{
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)
        _dynamics->advance(visitor.getFrameStamp());
    osgUtil::CullVisitor* view = visitor.asCullVisitor();
    if (!view)
    {
        osg::Geode::traverse(visitor);
        return;
    }
    if (dynamic_cast<CaptureVisitor*>(view) || !ViewRecord::serves(*view)) return;

    getBound(); // the sheets are as of the last bound
    const osg::ref_ptr<const WaveState> waves = _dynamics->advance(view->getFrameStamp());
    ViewRecord* record = nullptr;
    const std::shared_ptr<const Sheets> all = sheets();
    for (std::size_t i = 0; i < all->size(); ++i)
    {
        const StillWater& sheet = *(*all)[i];
        if (view->isCulled(sheet.localBound(_waveBounds->amplitude))) continue;
        if (!record) remember(*(record = &ViewRecord::of(*view)));
        record->waterView(*view).enrol(
            *view, {this, &sheet, static_cast<unsigned int>(i), waves, _waveBounds, _status});
    }
}

std::vector<WaterStatus> WaterSurface::getStatus() const
{
    return _status->read();
}

void WaterSurface::remember(ViewRecord& record)
{
    const std::lock_guard<std::mutex> lock(_viewRecordsMutex);
    _viewRecords.erase(std::remove_if(_viewRecords.begin(), _viewRecords.end(),
                                      [](const auto& observed) { return !observed.valid(); }),
                       _viewRecords.end());
    const auto found = std::find(_viewRecords.begin(), _viewRecords.end(), &record);
    if (found == _viewRecords.end()) _viewRecords.push_back(&record);
}

std::vector<osg::ref_ptr<ViewRecord>> WaterSurface::viewRecords() const
{
    const std::lock_guard<std::mutex> lock(_viewRecordsMutex);
    std::vector<osg::ref_ptr<ViewRecord>> records;
    for (const osg::observer_ptr<ViewRecord>& observed : _viewRecords)
    {
        osg::ref_ptr<ViewRecord> record;
        if (observed.lock(record)) records.push_back(record);
    }
    return records;
}

void WaterSurface::releaseGLObjects(osg::State* state) const
{
    for (const osg::ref_ptr<ViewRecord>& record : viewRecords())
        record->release(*this, state);
    for (const osg::ref_ptr<StillWater>& sheet : *sheets())
        sheet->calmMesh()->releaseGLObjects(state);
    if (_sky) _sky->releaseGLObjects(state);
    osg::Geode::releaseGLObjects(state);
}

void WaterSurface::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (const osg::ref_ptr<ViewRecord>& record : viewRecords())
        record->resizeGLObjectBuffers(maxSize);
    for (const osg::ref_ptr<StillWater>& sheet : *sheets())
        sheet->calmMesh()->resizeGLObjectBuffers(maxSize);
    if (_sky) _sky->resizeGLObjectBuffers(maxSize);
    osg::Geode::resizeGLObjectBuffers(maxSize);
}
