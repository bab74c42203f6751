#ifndef OSGWATERREFLECT_TESTS_SUPPORT_DIVIDEDWATER_H
#define OSGWATERREFLECT_TESTS_SUPPORT_DIVIDEDWATER_H

#include <osgWaterReflect/surface/WaveMesh.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <utility>
#include <vector>

/// Sheets of water as a WaveMesh divides them for a view, and what holds for every division.
namespace dividedWater
{

/// A view of the sheet, 640 x 480 pixels at 46 degrees, z up: the surface frame of these flat lakes
/// is the local one.
osgWaterReflect::SheetView viewFrom(const glm::dvec3& eye, const glm::dvec3& centre,
                                    double waveLength = 0.5, double amplitude = 0.02);

/// The triangles of a division, three indices each.
struct Mesh
{
    std::vector<glm::dvec2> places; ///< surface space
    std::vector<unsigned int> triangles;
};

/// What a mesh was divided into; fails the running test where it is not sound: not finite, not in
/// the plane, or without some corner.
Mesh read(const osgWaterReflect::WaveMesh& waveMesh);

/// Divides a sheet for a view, in a mesh of its own.
Mesh divide(const osgWaterReflect::StillWater& water, const osgWaterReflect::SheetView& view,
            const osgWaterReflect::SurfaceDetail& detail = {});

/// Above 0 where a, b and c run counter clockwise.
double signedArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Sum of the triangles' signed areas.
double areaOf(const std::vector<glm::dvec2>& places, const std::vector<unsigned int>& triangles);

/// Edges with their number of triangles in either direction.
std::map<std::pair<unsigned int, unsigned int>, int> edgesOf(const std::vector<unsigned int>& t);

/// Checks that edges belong to two triangles that run along it in opposite directions, and those of
/// one triangle lie on the still outline. With parts outside the view left out, edges of one
/// triangle may also lie wholly beside the view.
void checkWatertight(const osgWaterReflect::StillWater& water, const Mesh& mesh,
                     const osgWaterReflect::SheetView* view = nullptr);

} // namespace dividedWater

#endif
