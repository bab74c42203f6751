#include "Normals.h"

#include <osg/Math>

#include <array>
#include <cmath>
#include <map>

namespace waterdata
{

namespace
{

using Place = std::array<int, 3>;

Place weldedPlace(const osg::Vec3& point)
{
    const float grid = 2048.0f;
    return {static_cast<int>(std::lround(point.x() * grid)),
            static_cast<int>(std::lround(point.y() * grid)),
            static_cast<int>(std::lround(point.z() * grid))};
}

}

std::vector<osg::Vec3> cornerNormals(const Mesh& mesh)
{
    // Not normalised: a face counts by its area.
    std::vector<osg::Vec3> faces;
    std::map<Place, std::vector<std::size_t>> meeting;
    for (const Triangle& triangle : mesh.triangles)
    {
        for (const osg::Vec3& corner : triangle.corners)
            meeting[weldedPlace(corner)].push_back(faces.size());
        faces.push_back((triangle.corners[1] - triangle.corners[0])
                        ^ (triangle.corners[2] - triangle.corners[0]));
    }

    const float leastCosine = std::cos(osg::DegreesToRadians(mesh.creaseAngle));
    std::vector<osg::Vec3> normals;
    for (std::size_t face = 0; face < faces.size(); ++face)
    {
        for (const osg::Vec3& corner : mesh.triangles[face].corners)
        {
            osg::Vec3 sum;
            for (std::size_t other : meeting[weldedPlace(corner)])
            {
                const float lengths = faces[face].length() * faces[other].length();
                if (faces[face] * faces[other] >= leastCosine * lengths)
                    sum += faces[other];
            }
            sum.normalize();
            normals.push_back(sum);
        }
    }
    return normals;
}

}
