#include "ConvexHull.h"

#include <algorithm>
#include <cstddef>

using namespace osgWaterReflect;

namespace
{

// Above 0 where a, b and c run counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Appends the lower chain of points sorted by x, without its last corner: the next chain's first.
template <class Iterator>
void appendChain(std::vector<glm::dvec2>& hull, Iterator first, Iterator last)
{
    const std::size_t start = hull.size();
    for (; first != last; ++first)
    {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *first) <= 0.0)
            hull.pop_back();
        hull.push_back(*first);
    }
    hull.pop_back();
}

} // namespace

// The monotone chain [Andrew79].
std::vector<glm::dvec2> osgWaterReflect::convexHull(std::vector<glm::dvec2> points)
{
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b)
              { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) return points;

    std::vector<glm::dvec2> hull;
    hull.reserve(points.size() + 1);
    appendChain(hull, points.begin(), points.end());
    appendChain(hull, points.rbegin(), points.rend());
    return hull;
}
