#include "DividedWater.h"

#include "Catch.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace osgWaterReflect;

namespace
{

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const double s = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + s * (b - a));
}

} // namespace

SheetView dividedWater::viewFrom(const glm::dvec3& eye, const glm::dvec3& centre, double waveLength,
                                 double amplitude)
{
    SheetView view;
    view.viewportWidth = 640.0;
    view.viewportHeight = 480.0;
    view.clipFromEye = glm::perspective(glm::radians(46.0), 640.0 / 480.0, 0.1, 2000.0);
    const glm::dvec3 along = glm::normalize(centre - eye);
    const glm::dvec3 up = std::abs(along.z) > 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    view.eyeFromSurface = glm::lookAt(eye, centre, up);
    view.waves.amplitude = amplitude;
    view.waves.shortestEdge = waveLength / 8.0;
    return view;
}

dividedWater::Mesh dividedWater::read(const WaveMesh& waveMesh)
{
    Mesh mesh;
    const auto& vertices = static_cast<osg::Vec3Array&>(*waveMesh.geometry()->getVertexArray());
    const auto& indices =
        static_cast<osg::DrawElementsUInt&>(*waveMesh.geometry()->getPrimitiveSet(0));
    bool sound = true;
    for (const osg::Vec3& vertex : vertices)
    {
        sound =
            sound && std::isfinite(vertex.x()) && std::isfinite(vertex.y()) && vertex.z() == 0.0f;
        mesh.places.push_back(glm::dvec2(vertex.x(), vertex.y()) + waveMesh.anchor());
    }
    mesh.triangles.assign(indices.begin(), indices.end());
    REQUIRE(mesh.triangles.size() % 3 == 0);
    for (unsigned int index : mesh.triangles)
        sound = sound && index < mesh.places.size();
    REQUIRE(sound);
    return mesh;
}

dividedWater::Mesh dividedWater::divide(const StillWater& water, const SheetView& view,
                                        const SurfaceDetail& detail)
{
    osg::ref_ptr<WaveMesh> mesh = new WaveMesh;
    mesh->update(water, view, detail);
    return read(*mesh);
}

double dividedWater::signedArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

double dividedWater::areaOf(const std::vector<glm::dvec2>& places,
                            const std::vector<unsigned int>& triangles)
{
    double area = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        area +=
            signedArea(places[triangles[i]], places[triangles[i + 1]], places[triangles[i + 2]]);
    return area;
}

std::map<std::pair<unsigned int, unsigned int>, int>
dividedWater::edgesOf(const std::vector<unsigned int>& t)
{
    std::map<std::pair<unsigned int, unsigned int>, int> edges;
    for (std::size_t i = 0; i < t.size(); i += 3)
        for (int j = 0; j < 3; ++j)
            ++edges[{t[i + j], t[i + (j + 1) % 3]}];
    return edges;
}

void dividedWater::checkWatertight(const StillWater& water, const Mesh& mesh, const SheetView* view)
{
    // The outline: edges of the still sheet with one triangle.
    std::vector<std::pair<glm::dvec2, glm::dvec2>> outline;
    const auto still = edgesOf(water.triangles());
    for (const auto& edge : still)
        if (!still.count({edge.first.second, edge.first.first}))
            outline.push_back(
                {water.corners()[edge.first.first], water.corners()[edge.first.second]});

    const auto edges = edgesOf(mesh.triangles);
    int offOutline = 0;
    int doubled = 0;
    for (const auto& edge : edges)
    {
        doubled += edge.second != 1;
        if (edges.count({edge.first.second, edge.first.first})) continue;
        const glm::dvec2& a = mesh.places[edge.first.first];
        const glm::dvec2& b = mesh.places[edge.first.second];
        // Vertices are single precision about the anchor.
        const double tolerance = 1e-6 * (1.0 + glm::length(a) + glm::length(b));
        bool explained = false;
        for (const auto& side : outline)
            explained = explained || (distanceToSegment(a, side.first, side.second) < tolerance &&
                                      distanceToSegment(b, side.first, side.second) < tolerance);
        if (!explained && view)
        {
            // Beyond the same side of the view, raised or lowered.
            for (int axis = 0; axis < 3 && !explained; ++axis)
                for (double sign : {-1.0, 1.0})
                {
                    bool beyond = true;
                    for (const glm::dvec2& place : {a, b})
                        for (double height : {-view->waves.amplitude, view->waves.amplitude})
                        {
                            const glm::dvec4 clip = view->clipFromEye * view->eyeFromSurface *
                                                    glm::dvec4(place, height, 1.0);
                            const double other = axis < 2 ? sign * clip[axis] : 0.0;
                            beyond = beyond && clip.w + other < 1e-6;
                        }
                    explained = explained || beyond;
                }
        }
        offOutline += !explained;
    }
    CHECK(doubled == 0);
    CHECK(offOutline == 0);
}
