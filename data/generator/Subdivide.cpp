#include "Subdivide.h"

#include <osg/Math>

#include <utility>

namespace waterdata
{

namespace
{

const float fullDetailDistance = 35.0f;

bool tooLong(const osg::Vec3& a, const osg::Vec3& b, float longestEdge, const osg::Vec3& focus)
{
    const float distance = ((a + b) * 0.5f - focus).length();
    const float limit = longestEdge * std::max(1.0f, distance / fullDetailDistance);
    return (a - b).length2() > limit * limit;
}

// Splits the triangle at its first overlong edge; the two halves go on the stack.
bool split(const Triangle& triangle, float longestEdge, const osg::Vec3& focus,
           std::vector<Triangle>& stack)
{
    int worst = -1;
    float worstLength = 0.0f;
    for (int edge = 0; edge < 3; ++edge)
    {
        const osg::Vec3& a = triangle.corners[edge];
        const osg::Vec3& b = triangle.corners[(edge + 1) % 3];
        const float length = (a - b).length2();
        if (length > worstLength && tooLong(a, b, longestEdge, focus))
        {
            worst = edge;
            worstLength = length;
        }
    }
    if (worst < 0)
        return false;

    const int next = (worst + 1) % 3;
    const osg::Vec3 middle = (triangle.corners[worst] + triangle.corners[next]) * 0.5f;
    const Colour paint = (triangle.colours[worst] + triangle.colours[next]) * 0.5f;
    Triangle first = triangle;
    Triangle second = triangle;
    first.corners[next] = middle;
    first.colours[next] = paint;
    second.corners[worst] = middle;
    second.colours[worst] = paint;
    stack.push_back(first);
    stack.push_back(second);
    return true;
}

}

void subdivide(Mesh& mesh, const osg::Vec3& focus)
{
    if (mesh.longestEdge <= 0.0f)
        return;
    std::vector<Triangle> finished;
    std::vector<Triangle> stack = std::move(mesh.triangles);
    while (!stack.empty())
    {
        const Triangle triangle = stack.back();
        stack.pop_back();
        if (!split(triangle, mesh.longestEdge, focus, stack))
            finished.push_back(triangle);
    }
    mesh.triangles = std::move(finished);
}

}
