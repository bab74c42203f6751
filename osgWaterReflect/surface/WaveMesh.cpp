#include "WaveMesh.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cstdint>
#include <limits>

using namespace osgWaterReflect;

namespace
{

struct Corner
{
    glm::dvec2 place;     // surface space
    glm::dvec3 eye;       // eye space, scaled to surface units
    unsigned int outside; // a bit for each side of the view that no wave brings it back over
};

struct Triangle
{
    unsigned int corner[3];
};

// The corner in the middle of each edge that was halved: a flat table with open addressing, for
// it is asked twice for every corner of the mesh.
class EdgeMiddles
{
public:
    static constexpr unsigned int NONE = std::numeric_limits<unsigned int>::max();

    EdgeMiddles() : _slots(256) {}

    // The middle of an edge from a to b, a < b, to be set where it is still NONE.
    unsigned int& at(unsigned int a, unsigned int b)
    {
        if (2 * (_used + 1) > _slots.size()) grow();
        Slot& slot = find(static_cast<std::uint64_t>(a) << 32 | b);
        _used += slot.middle == NONE;
        return slot.middle;
    }

private:
    struct Slot
    {
        std::uint64_t edge = 0;
        unsigned int middle = NONE;
    };

    Slot& find(std::uint64_t edge)
    {
        // Fibonacci hashing: the multiplier is 2^64 over the golden ratio.
        const std::size_t mask = _slots.size() - 1;
        std::size_t i = (edge * 0x9E3779B97F4A7C15u) >> 32 & mask;
        while (_slots[i].middle != NONE && _slots[i].edge != edge)
            i = (i + 1) & mask;
        _slots[i].edge = edge;
        return _slots[i];
    }

    void grow()
    {
        std::vector<Slot> old(2 * _slots.size());
        old.swap(_slots);
        for (const Slot& slot : old)
            if (slot.middle != NONE) find(slot.edge).middle = slot.middle;
    }

    std::vector<Slot> _slots; // a power of two, at most half of them used
    std::size_t _used = 0;
};

// Divides one sheet for one view. A coarsening multiplies every length that an edge may have: edges
// are asked about as if they were shorter by it.
class Division
{
public:
    Division(const StillWater& water, const SheetView& view, const SurfaceDetail& detail,
             double coarsening) :
        _clipFromSurface(view.clipFromEye * view.eyeFromSurface),
        _clipAmplitude(view.waves.amplitude * _clipFromSurface[2]),
        _chordErrors(view.waves.chordErrors), _perSquaredCoarsening(1.0 / (coarsening * coarsening))
    {
        const double eyeUnitsPerUnit = glm::length(glm::dvec3(view.eyeFromSurface[0]));
        _scaledFromSurface = view.eyeFromSurface / eyeUnitsPerUnit;
        _squaredHeight = square(glm::inverse(view.eyeFromSurface)[3][2]);

        // Clip w grows with the distance along the view by this; it does not in an orthographic
        // view.
        const double depthScale = std::abs(view.clipFromEye[2][3]);
        _orthographic = depthScale == 0.0;
        const double pixelsPerUnit =
            0.5 *
            std::max(view.viewportWidth * std::abs(view.clipFromEye[0][0]),
                     view.viewportHeight * std::abs(view.clipFromEye[1][1])) /
            (_orthographic ? std::abs(view.clipFromEye[3][3]) / eyeUnitsPerUnit : depthScale);
        _squaredEdge = square(detail.maxEdgePixels / pixelsPerUnit);
        _squaredError = square(detail.maxErrorPixels / pixelsPerUnit);

        glm::dvec2 lowest(std::numeric_limits<double>::infinity());
        glm::dvec2 highest = -lowest;
        for (const glm::dvec2& place : water.corners())
        {
            addCorner(place);
            lowest = glm::min(lowest, place);
            highest = glm::max(highest, place);
        }
        // Where a wave model knows no shortest wave, an edge at the eye could be halved for ever.
        const double floor = glm::distance(lowest, highest) * SHORTEST_PART;
        _squaredShortest = square(std::max(view.waves.shortestEdge, floor));

        const std::vector<unsigned int>& indices = water.triangles();
        for (std::size_t i = 0; i < indices.size(); i += 3)
            _open.push_back({{indices[i], indices[i + 1], indices[i + 2]}});
    }

    // False where more corners than allowed were needed.
    bool run(unsigned int maxCorners)
    {
        const std::size_t limit = std::max<std::size_t>(maxCorners, corners.size());
        while (!_open.empty())
        {
            const Triangle triangle = _open.back();
            _open.pop_back();
            if (outsideView(triangle)) continue;
            divide(triangle);
            if (corners.size() > limit) return false;
        }
        return true;
    }

    std::vector<Corner> corners;
    std::vector<Triangle> done;

private:
    // [1] of the sheet's size; single precision about the anchor tells no nearer places apart
    // than a 2^24th.
    static constexpr double SHORTEST_PART = 1.0 / (1 << 30);

    unsigned int addCorner(const glm::dvec2& place)
    {
        const glm::dvec4 clip =
            place.x * _clipFromSurface[0] + place.y * _clipFromSurface[1] + _clipFromSurface[3];
        unsigned int outside = 0;
        for (int axis = 0; axis < 2; ++axis)
            for (double sign : {-1.0, 1.0})
            {
                const double reach = std::abs(_clipAmplitude.w + sign * _clipAmplitude[axis]);
                outside = outside << 1 | (clip.w + sign * clip[axis] + reach < 0.0);
            }
        // Behind the eye.
        outside = outside << 1 | (clip.w + std::abs(_clipAmplitude.w) < 0.0);

        corners.push_back({place,
                           glm::dvec3(place.x * _scaledFromSurface[0] +
                                      place.y * _scaledFromSurface[1] + _scaledFromSurface[3]),
                           outside});
        return static_cast<unsigned int>(corners.size() - 1);
    }

    // Whether the triangle, moved by waves, lies wholly beyond a side of the view's frustum.
    bool outsideView(const Triangle& triangle) const
    {
        return corners[triangle.corner[0]].outside & corners[triangle.corner[1]].outside &
               corners[triangle.corner[2]].outside;
    }

    // Of an edge from a to b, a < b: both its triangles must come to the same answer, to the last
    // bit.
    bool tooLong(unsigned int a, unsigned int b) const
    {
        const glm::dvec3 edge = corners[b].eye - corners[a].eye;
        const double squaredLength = glm::dot(edge, edge) * _perSquaredCoarsening;
        if (squaredLength <= _squaredShortest) return false;
        if (_orthographic) return isStrayedFrom(squaredLength, 1.0, 1.0);

        const double squaredDepth = squaredDistance(corners[a].eye, edge);
        // The nearest that a triangle with this for its longest side comes to the eye: it reaches
        // no farther from that side than an equilateral one.
        const double beside = std::sqrt(std::max(squaredDepth - _squaredHeight, 0.0)) -
                              0.5 * std::sqrt(3.0 * glm::dot(edge, edge));
        return isStrayedFrom(squaredLength, squaredDepth,
                             _squaredHeight + square(std::max(beside, 0.0)));
    }

    // Whether an edge is too long at a depth, and waves stray from it too far at another.
    bool isStrayedFrom(double squaredLength, double squaredDepth, double squaredNearest) const
    {
        return squaredLength > _squaredEdge * squaredDepth &&
               _chordErrors.squaredAt(squaredLength) > _squaredError * squaredNearest;
    }

    // From the eye to the nearest point of an edge: the foot of the eye, or one of its ends.
    static double squaredDistance(const glm::dvec3& start, const glm::dvec3& edge)
    {
        const double s = glm::clamp(-glm::dot(start, edge) / glm::dot(edge, edge), 0.0, 1.0);
        const glm::dvec3 nearest = start + s * edge;
        return glm::dot(nearest, nearest);
    }

    static double square(double value) { return value * value; }

    unsigned int middle(unsigned int a, unsigned int b)
    {
        unsigned int& middle = _middles.at(std::min(a, b), std::max(a, b));
        if (middle == EdgeMiddles::NONE)
            middle = addCorner(0.5 * (corners[a].place + corners[b].place));
        return middle;
    }

    void divide(const Triangle& triangle)
    {
        bool split[3];
        int splits = 0;
        for (int i = 0; i < 3; ++i)
        {
            const unsigned int a = triangle.corner[i];
            const unsigned int b = triangle.corner[(i + 1) % 3];
            split[i] = tooLong(std::min(a, b), std::max(a, b));
            splits += split[i];
        }
        if (splits == 0)
        {
            done.push_back(triangle);
            return;
        }

        // Turned so that the first edge is split and, where two are, the third is not.
        int first = 0;
        while (!split[first] || (splits == 2 && split[(first + 2) % 3]))
            first = (first + 1) % 3;
        const unsigned int a = triangle.corner[first];
        const unsigned int b = triangle.corner[(first + 1) % 3];
        const unsigned int c = triangle.corner[(first + 2) % 3];
        const unsigned int ab = middle(a, b);
        if (splits == 1)
        {
            _open.insert(_open.end(), {{{a, ab, c}}, {{ab, b, c}}});
            return;
        }
        const unsigned int bc = middle(b, c);
        _open.push_back({{ab, b, bc}});
        if (splits == 2)
        {
            _open.insert(_open.end(), {{{a, ab, bc}}, {{a, bc, c}}});
            return;
        }
        const unsigned int ca = middle(c, a);
        _open.insert(_open.end(), {{{a, ab, ca}}, {{ca, bc, c}}, {{ab, bc, ca}}});
    }

    glm::dmat4 _scaledFromSurface{1.0}; // to eye space, scaled to surface units
    glm::dmat4 _clipFromSurface;
    glm::dvec4 _clipAmplitude;
    ChordErrors _chordErrors;
    double _perSquaredCoarsening;
    bool _orthographic = false;

    // What an edge may have, squared. In a perspective view at a depth of 1, in surface units.
    double _squaredEdge = 0.0;
    double _squaredError = 0.0;
    double _squaredShortest = 0.0; // at any depth

    double _squaredHeight = 0.0; // of the eye over the still plane
    std::vector<Triangle> _open;
    EdgeMiddles _middles;
};

// Of the near and far planes nothing is left.
glm::dmat4 withoutClipZ(glm::dmat4 clipFromEye)
{
    for (int column = 0; column < 4; ++column)
        clipFromEye[column][2] = 0.0;
    return clipFromEye;
}

bool divideAlike(const WaveBounds& a, const WaveBounds& b)
{
    return a.amplitude == b.amplitude && a.shortestEdge == b.shortestEdge &&
           a.chordErrors == b.chordErrors;
}

} // namespace

bool SheetView::operator==(const SheetView& rhs) const
{
    return eyeFromSurface == rhs.eyeFromSurface &&
           withoutClipZ(clipFromEye) == withoutClipZ(rhs.clipFromEye) &&
           viewportWidth == rhs.viewportWidth && viewportHeight == rhs.viewportHeight &&
           divideAlike(waves, rhs.waves);
}

WaveMesh::WaveMesh() : _geometry(createSurfaceGeometry()) {}

void WaveMesh::update(const StillWater& water, const SheetView& view, const SurfaceDetail& detail)
{
    const osg::observer_ptr<const StillWater> sheet = &water;
    if (_water == sheet && _view == view && _detail == detail) return;
    _water = sheet;
    _view = view;
    _detail = detail;

    // Coarser by steps until it fits; finer again once half the corners would do. A step changes
    // their number by its square, so that the two do not chase each other.
    const double step = 1.25;
    Division division(water, view, detail, _coarsening);
    while (!division.run(detail.maxVertices))
    {
        _coarsening *= step;
        division = Division(water, view, detail, _coarsening);
    }
    while (_coarsening > 1.0 && 2 * division.corners.size() < detail.maxVertices)
    {
        const double finer = std::max(1.0, _coarsening / step);
        Division finerDivision(water, view, detail, finer);
        if (!finerDivision.run(detail.maxVertices)) break;
        _coarsening = finer;
        division = std::move(finerDivision);
    }

    const glm::dvec4 eyeSurface = glm::inverse(view.eyeFromSurface) * glm::dvec4(0, 0, 0, 1);
    _anchor = glm::dvec2(eyeSurface);

    auto* vertices = static_cast<osg::Vec3Array*>(_geometry->getVertexArray());
    auto* indices = static_cast<osg::DrawElementsUInt*>(_geometry->getPrimitiveSet(0));
    vertices->clear();
    indices->clear();
    vertices->reserve(division.corners.size());
    indices->reserve(3 * division.done.size());
    for (const Corner& corner : division.corners)
        vertices->push_back(
            osg::Vec3(corner.place.x - _anchor.x, corner.place.y - _anchor.y, 0.0f));
    for (const Triangle& triangle : division.done)
        indices->insert(indices->end(), triangle.corner, triangle.corner + 3);
    vertices->dirty();
    indices->dirty();
    _geometry->dirtyBound();
}
