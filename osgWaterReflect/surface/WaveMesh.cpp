#include "WaveMesh.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <unordered_map>

using namespace osgWaterReflect;

namespace
{

struct Corner
{
    glm::dvec2 place; // surface space
    glm::dvec3 eye;
    glm::dvec4 clip;
};

struct Triangle
{
    unsigned int corner[3];
};

// Divides one sheet for one view and one length of edges on screen.
class Division
{
public:
    Division(const StillWater& water, const SheetView& view, double maxEdgePixels) :
        _view(view), _clipFromSurface(view.clipFromEye * view.eyeFromSurface),
        _clipAmplitude(view.amplitude * _clipFromSurface[2])
    {
        const double pixelsPerUnit = 0.5 * std::max(view.viewportWidth * view.clipFromEye[0][0],
                                                    view.viewportHeight * view.clipFromEye[1][1]);
        _orthographic = view.clipFromEye[2][3] == 0.0;
        _lengthPerDepth = maxEdgePixels / pixelsPerUnit;
        _shortestEdge = view.shortestEdge * glm::length(glm::dvec3(view.eyeFromSurface[0]));
        for (const glm::dvec2& place : water.corners())
            addCorner(place);
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
    unsigned int addCorner(const glm::dvec2& place)
    {
        const glm::dvec4 surface(place, 0.0, 1.0);
        corners.push_back({place, glm::dvec3(_view.eyeFromSurface * surface),
                           _clipFromSurface * surface});
        return static_cast<unsigned int>(corners.size() - 1);
    }

    // Whether the triangle, moved by waves, lies wholly beyond a side of the view's frustum.
    bool outsideView(const Triangle& triangle) const
    {
        for (int axis = 0; axis < 2; ++axis)
            for (double sign : {-1.0, 1.0})
            {
                const double reach =
                    std::abs(_clipAmplitude.w + sign * _clipAmplitude[axis]);
                bool outside = true;
                for (unsigned int corner : triangle.corner)
                {
                    const glm::dvec4& clip = corners[corner].clip;
                    outside = outside && clip.w + sign * clip[axis] + reach < 0.0;
                }
                if (outside) return true;
            }
        return false;
    }

    bool tooLong(unsigned int a, unsigned int b) const
    {
        const glm::dvec3& p = corners[a].eye;
        const glm::dvec3 edge = corners[b].eye - p;
        const double squaredLength = glm::dot(edge, edge);
        if (squaredLength <= _shortestEdge * _shortestEdge) return false;
        if (_orthographic) return squaredLength > _lengthPerDepth * _lengthPerDepth;
        const double s = glm::clamp(-glm::dot(p, edge) / squaredLength, 0.0, 1.0);
        const glm::dvec3 nearest = p + s * edge;
        return squaredLength > _lengthPerDepth * _lengthPerDepth * glm::dot(nearest, nearest);
    }

    unsigned int middle(unsigned int a, unsigned int b)
    {
        const std::uint64_t low = std::min(a, b);
        const std::uint64_t high = std::max(a, b);
        const auto found = _middles.emplace(low << 32 | high, 0u);
        if (found.second)
            found.first->second = addCorner(0.5 * (corners[a].place + corners[b].place));
        return found.first->second;
    }

    void divide(const Triangle& triangle)
    {
        bool split[3];
        int splits = 0;
        for (int i = 0; i < 3; ++i)
        {
            split[i] = tooLong(triangle.corner[i], triangle.corner[(i + 1) % 3]);
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

    SheetView _view;
    glm::dmat4 _clipFromSurface;
    glm::dvec4 _clipAmplitude;
    bool _orthographic = false;
    double _lengthPerDepth = 0.0;
    double _shortestEdge = 0.0; // [eye units]
    std::vector<Triangle> _open;
    std::unordered_map<std::uint64_t, unsigned int> _middles;
};

} // namespace

bool SheetView::operator==(const SheetView& rhs) const
{
    return eyeFromSurface == rhs.eyeFromSurface && clipFromEye == rhs.clipFromEye &&
           viewportWidth == rhs.viewportWidth && viewportHeight == rhs.viewportHeight &&
           amplitude == rhs.amplitude && shortestEdge == rhs.shortestEdge;
}

WaveMesh::WaveMesh() : _geometry(createSurfaceGeometry()) {}

void WaveMesh::update(const StillWater& water, const SheetView& view, const SurfaceDetail& detail)
{
    if (_water == &water && _view == view && _detail == detail) return;
    _water = &water;
    _view = view;
    _detail = detail;

    // Coarser by steps until it fits; finer again, by one step a frame, once there is room.
    const double step = 1.25;
    Division division(water, view, detail.maxEdgePixels * _coarsening);
    while (!division.run(detail.maxVertices))
    {
        _coarsening *= step;
        division = Division(water, view, detail.maxEdgePixels * _coarsening);
    }
    if (_coarsening > 1.0 && division.corners.size() < detail.maxVertices / (2.0 * step))
        _coarsening = std::max(1.0, _coarsening / step);

    const glm::dvec4 eyeSurface = glm::inverse(view.eyeFromSurface) * glm::dvec4(0, 0, 0, 1);
    _anchor = glm::dvec2(eyeSurface);

    auto* vertices = static_cast<osg::Vec3Array*>(_geometry->getVertexArray());
    auto* indices = static_cast<osg::DrawElementsUInt*>(_geometry->getPrimitiveSet(0));
    vertices->clear();
    indices->clear();
    for (const Corner& corner : division.corners)
        vertices->push_back(
            osg::Vec3(corner.place.x - _anchor.x, corner.place.y - _anchor.y, 0.0f));
    for (const Triangle& triangle : division.done)
        indices->insert(indices->end(), triangle.corner, triangle.corner + 3);
    vertices->dirty();
    indices->dirty();
    _geometry->dirtyBound();
}
