#include "Shapes.h"

#include <osg/Math>
#include <osg/Quat>

#include <cmath>

namespace waterdata
{

void addBox(Mesh& mesh, const osg::Vec3& low, const osg::Vec3& high, const Colour& paint)
{
    addSlab(mesh, {low.x(), low.y(), high.z()}, {high.x(), low.y(), high.z()}, high,
            {low.x(), high.y(), high.z()}, {0.0f, 0.0f, low.z() - high.z()}, paint);
}

void addSlab(Mesh& mesh, const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c,
             const osg::Vec3& d, const osg::Vec3& depth, const Colour& paint)
{
    const bool seenFromAbove = ((b - a) ^ (c - a)) * depth < 0.0f;
    const osg::Vec3 upper[4] = {a, seenFromAbove ? b : d, c, seenFromAbove ? d : b};
    mesh.quad(upper[0], upper[1], upper[2], upper[3], paint);
    mesh.quad(upper[3] + depth, upper[2] + depth, upper[1] + depth, upper[0] + depth, paint);
    for (int side = 0; side < 4; ++side)
    {
        const osg::Vec3& here = upper[side];
        const osg::Vec3& next = upper[(side + 1) % 4];
        mesh.quad(here + depth, next + depth, next, here, paint);
    }
}

void addTube(Mesh& mesh, const osg::Vec3& from, const osg::Vec3& to, float radiusFrom,
             float radiusTo, int sides, const Colour& paint)
{
    const osg::Vec3 along = to - from;
    osg::Quat turn;
    turn.makeRotate(osg::Vec3(0.0f, 0.0f, 1.0f), along);
    const Placed placed(mesh, osg::Matrixd::rotate(turn) * osg::Matrixd::translate(from));
    const float length = along.length();
    addTurned(mesh, {{0.0f, 0.0f}, {radiusFrom, 0.0f}, {radiusTo, length}, {0.0f, length}}, sides,
              [&paint](int, int) { return paint; });
}

void addTurned(Mesh& mesh, const std::vector<osg::Vec2>& profile, int sides,
               const SurfacePaint& paint)
{
    const auto point = [&](std::size_t row, int side)
    {
        const float angle = 2.0f * osg::PIf * static_cast<float>(side % sides) / sides;
        const osg::Vec2& outline = profile[row];
        return osg::Vec3(outline.x() * std::cos(angle), outline.x() * std::sin(angle), outline.y());
    };
    for (std::size_t row = 0; row + 1 < profile.size(); ++row)
    {
        for (int side = 0; side < sides; ++side)
        {
            const Colour here = paint(static_cast<int>(row), side);
            if (profile[row].x() > 0.0f)
                mesh.triangle(point(row, side), point(row, side + 1), point(row + 1, side + 1),
                              here);
            if (profile[row + 1].x() > 0.0f)
                mesh.triangle(point(row, side), point(row + 1, side + 1), point(row + 1, side),
                              here);
        }
    }
}

void addBall(Mesh& mesh, const osg::Vec3& centre, const osg::Vec3& radii, int sides,
             const Colour& paint)
{
    const int rows = sides / 2;
    std::vector<osg::Vec2> profile;
    for (int row = 0; row <= rows; ++row)
    {
        const float angle = osg::PIf * (static_cast<float>(row) / rows - 0.5f);
        const bool pole = row == 0 || row == rows;
        profile.push_back({pole ? 0.0f : std::cos(angle), std::sin(angle)});
    }
    const Placed placed(mesh, osg::Matrixd::scale(radii) * osg::Matrixd::translate(centre));
    addTurned(mesh, profile, sides, [&paint](int, int) { return paint; });
}

void addRing(Mesh& mesh, float radius, float thickness, int sides, const Colour& paint)
{
    std::vector<osg::Vec2> profile;
    for (int corner = 0; corner <= 6; ++corner)
    {
        const float angle = 2.0f * osg::PIf * static_cast<float>(corner % 6) / 6.0f;
        profile.push_back({radius + thickness * std::cos(angle), thickness * std::sin(angle)});
    }
    addTurned(mesh, profile, sides, [&paint](int, int) { return paint; });
}

namespace
{

using Points = std::vector<osg::Vec3>;

Points icosahedron()
{
    const float golden = (1.0f + std::sqrt(5.0f)) / 2.0f;
    const osg::Vec3 p[12] = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                             {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                             {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    const int faces[60] = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11,
                           4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3,
                           6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1};
    Points corners;
    for (int index : faces)
        corners.push_back(p[index] / p[index].length());
    return corners;
}

Points refined(const Points& corners)
{
    const auto middle = [](const osg::Vec3& a, const osg::Vec3& b)
    {
        osg::Vec3 point = a + b;
        point.normalize();
        return point;
    };
    Points finer;
    for (std::size_t first = 0; first < corners.size(); first += 3)
    {
        const osg::Vec3 a = corners[first], b = corners[first + 1], c = corners[first + 2];
        const osg::Vec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    return finer;
}

}

void addFormedBall(Mesh& mesh, int level, const Form& form, const Colour& paint)
{
    Points corners = icosahedron();
    for (int step = 0; step < level; ++step)
        corners = refined(corners);
    for (std::size_t first = 0; first < corners.size(); first += 3)
        mesh.triangle(form(corners[first]), form(corners[first + 1]), form(corners[first + 2]),
                      paint);
}

}
