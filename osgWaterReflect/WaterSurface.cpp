#include <osgWaterReflect/WaterSurface>

#include "Check.h"
#include "capture/CaptureVisitor.h"
#include "surface/StillWater.h"
#include "view/StatusBoard.h"
#include "view/ViewRecord.h"

#include <osg/Geometry>
#include <osg/io_utils>
#include <osgUtil/Tessellator>

#include <algorithm>
#include <atomic>
#include <cmath>

using namespace osgWaterReflect;

namespace
{

bool isFinite(const osg::Vec3& v)
{
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

// [1] Of the squared size: an area below this is rounding of corners in single precision.
const double NO_AREA = 1e-7;

// Twice the area that an outline encloses, along its normal [Newell].
osg::Vec3d areaVector(const WaterSurface::Outline& outline)
{
    osg::Vec3d area;
    const osg::Vec3d origin(outline.front());
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        area += (osg::Vec3d(outline[i]) - origin) ^ (osg::Vec3d(outline[i + 1]) - origin);
    return area;
}

bool checkOutline(const WaterSurface::Outline& outline)
{
    const char* member = "WaterSurface::createPolygon";
    if (outline.size() < 3) return refuse(member, "at least 3 corners", outline.size());
    for (const osg::Vec3& corner : outline)
        if (!isFinite(corner)) return refuse(member, "finite corners", corner);
    double squaredSize = 0.0;
    for (const osg::Vec3& corner : outline)
        squaredSize =
            std::max(squaredSize, (osg::Vec3d(corner) - osg::Vec3d(outline.front())).length2());
    const double area = 0.5 * areaVector(outline).length();
    return area > NO_AREA * squaredSize || refuse(member, "an outline with an area", area);
}

// It is never drawn itself: nothing is to be compiled for it.
osg::ref_ptr<osg::Geometry> createGeometry(osg::Vec3Array* vertices)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(false);
    geometry->setVertexArray(vertices);
    return geometry;
}

bool expectDrawable(const char* member, const osg::Node* child)
{
    if (child && child->asDrawable()) return true;
    return refuse(member, "a drawable", child ? child->getCompoundClassName() : "null");
}

} // namespace

WaterSurface::WaterSurface() :
    _waveBounds(std::make_shared<WaveBounds>()), _status(std::make_shared<StatusBoard>())
{
}

WaterSurface::WaterSurface(const WaterSurface& rhs, const osg::CopyOp& copyop) :
    osg::Geode(rhs, copyop), _reflection(rhs._reflection), _viewSettings(rhs._viewSettings),
    _optics(rhs._optics), _detail(rhs._detail),
    _waves(static_cast<WaveModel*>(copyop(static_cast<osg::Object*>(rhs._waves.get())))),
    _waveBounds(rhs._waveBounds), _sky(static_cast<osg::TextureCubeMap*>(copyop(rhs._sky.get()))),
    _debugView(rhs._debugView), _status(std::make_shared<StatusBoard>())
{
}

WaterSurface::~WaterSurface() = default;

WaterSurface* WaterSurface::createRectangle(const osg::Vec3& centre, const osg::Vec3& lengthVec,
                                            const osg::Vec3& widthVec)
{
    const char* member = "WaterSurface::createRectangle";
    for (const osg::Vec3& v : {centre, lengthVec, widthVec})
        if (!isFinite(v))
        {
            refuse(member, "finite vectors", v);
            return nullptr;
        }
    const osg::Vec3d length(lengthVec);
    const osg::Vec3d width(widthVec);
    const double area = (length ^ width).length();
    if (!(area > NO_AREA * length.length() * width.length()))
    {
        refuse(member, "sides that span an area", area);
        return nullptr;
    }

    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const osg::Vec3 corner = centre - (lengthVec + widthVec) * 0.5f;
    vertices->push_back(corner);
    vertices->push_back(corner + lengthVec);
    vertices->push_back(corner + lengthVec + widthVec);
    vertices->push_back(corner + widthVec);
    osg::ref_ptr<osg::Geometry> geometry = createGeometry(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));

    osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->addDrawable(geometry);
    return water.release();
}

WaterSurface* WaterSurface::createPolygon(const Outline& outline, const std::vector<Outline>& holes)
{
    if (!checkOutline(outline)) return nullptr;
    for (const Outline& hole : holes)
        if (!checkOutline(hole)) return nullptr;

    // The outline's own way round decides only where the plane is vertical.
    osg::Vec3d normal = areaVector(outline);
    if (normal.z() < -1e-6 * normal.length()) normal = -normal;
    normal.normalize();

    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Geometry> geometry = createGeometry(vertices);
    const auto addContour = [&](const Outline& contour)
    {
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_POLYGON, vertices->size(), contour.size()));
        vertices->insert(vertices->end(), contour.begin(), contour.end());
    };
    addContour(outline);
    for (const Outline& hole : holes)
        addContour(hole);

    osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
    tessellator->setTessellationType(osgUtil::Tessellator::TESS_TYPE_GEOMETRY);
    tessellator->setWindingType(osgUtil::Tessellator::TESS_WINDING_ODD);
    tessellator->setTessellationNormal(normal);
    tessellator->retessellatePolygons(*geometry);

    osg::ref_ptr<WaterSurface> water = new WaterSurface;
    water->addDrawable(geometry);
    return water.release();
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

// The bound is computed at once: so whatever changes a drawable afterwards is told of it anew, and
// its sheets are not taken for those of before.
void WaterSurface::setWaves(WaveModel* waves)
{
    _waves = waves;
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

void WaterSurface::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* view = visitor.asCullVisitor();
    if (!view)
    {
        osg::Geode::traverse(visitor);
        return;
    }
    if (dynamic_cast<CaptureVisitor*>(view) || !ViewRecord::serves(*view)) return;

    getBound(); // the sheets are as of the last bound
    ViewRecord* record = nullptr;
    const std::shared_ptr<const Sheets> all = sheets();
    for (std::size_t i = 0; i < all->size(); ++i)
    {
        const StillWater& sheet = *(*all)[i];
        if (view->isCulled(sheet.localBound(_waveBounds->amplitude))) continue;
        if (!record) remember(*(record = &ViewRecord::of(*view)));
        record->waterView(*view).enrol(
            *view, {this, &sheet, static_cast<unsigned int>(i), _waveBounds, _status});
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
