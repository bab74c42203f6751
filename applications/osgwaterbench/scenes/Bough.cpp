#include "Bough.h"

#include "Mesh.h"

#include <osg/Math>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace osgwaterbench;

namespace
{

const osg::Vec3d SUN_DIR(-0.616, -0.555, 0.559); // towards the demo scenes' baked sun
const double AMBIENT = 0.5;                      // [1] of the colour
const osg::Vec3 BARK(0.36f, 0.31f, 0.27f);
const osg::Vec3 YOUNG_LEAF(0.56f, 0.66f, 0.25f);
const osg::Vec3 OLD_LEAF(0.27f, 0.44f, 0.17f);

// Where the limb comes from, from the eye [m]: so far to the left that no wider image shows its
// end.
const osg::Vec3d LIMB_FOOT(-6.8, 4.7, 1.55);
const double LIMB_LENGTH = 8.4;  // [m]
const double LIMB_RADIUS = 0.07; // [m]
const double LIMB_DROOP = 0.035;
const double BARE_LENGTH = 1.2; // [m] of the limb, without twigs

const double TWIG_SPACING = 0.1;   // [m] along the limb
const int TWIG_OFFSPRING = 3;      // smaller twigs on each
const double TWIG_DROOP = 2.2;     // a birch's hang
const double LEAF_SPACING = 0.035; // [m] along a twig, to both sides
const double STALK_LENGTH = 0.015; // [m]

// The standard fixes the engine's output but not that of its distributions.
class Random
{
public:
    double between(double low, double high) { return low + (high - low) * (_engine() * 0x1p-32); }

    osg::Vec3d inBall()
    {
        osg::Vec3d v;
        do
            v = osg::Vec3d{between(-1, 1), between(-1, 1), between(-1, 1)}; // braces keep the order
        while (v.length2() > 1.0);
        return v;
    }

private:
    std::mt19937 _engine{11};
};

osg::Vec3d unit(osg::Vec3d v)
{
    v.normalize();
    return v;
}

// How wood grows from a place: in steps, ever more downwards.
struct Shoot
{
    osg::Vec3d foot;
    osg::Vec3d dir;
    double length = 1.0; // [m]
    double radius = 0.0; // [m] at its foot; at the tip nothing
    double droop = 0.0;  // [1] by how much a metre turns it down
    double wobble = 0.0; // [1] by how much a step turns it anywhere
};

struct Node
{
    osg::Vec3d place;
    osg::Vec3d dir;
    double radius;
};

std::vector<Node> grow(const Shoot& shoot, double step, Random& random)
{
    const int steps = std::max(2, static_cast<int>(std::lround(shoot.length / step)));
    const double length = shoot.length / steps;
    std::vector<Node> nodes{{shoot.foot, shoot.dir, shoot.radius}};
    for (int i = 1; i <= steps; ++i)
    {
        const Node& last = nodes.back();
        const osg::Vec3d dir = unit(last.dir + osg::Vec3d(0, 0, -shoot.droop * length) +
                                    random.inBall() * shoot.wobble);
        const double taper = 1.0 - static_cast<double>(i) / (steps + 1);
        nodes.push_back({last.place + dir * length, dir, shoot.radius * taper});
    }
    return nodes;
}

void addWood(Mesh& mesh, const std::vector<Node>& nodes, int sides)
{
    const auto corner = [&](const Node& node, int side)
    {
        const osg::Vec3d across = unit(node.dir ^ osg::Vec3d(0.1, 0.2, 1.0));
        const double angle = 2.0 * osg::PI * side / sides;
        const osg::Vec3d normal = across * std::cos(angle) + (node.dir ^ across) * std::sin(angle);
        const double light = AMBIENT + (1.0 - AMBIENT) * std::max(0.0, normal * SUN_DIR);
        return Mesh::Corner{node.place + normal * node.radius, BARK * static_cast<float>(light)};
    };
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (int side = 0; side < sides; ++side)
        {
            const Mesh::Corner a = corner(nodes[i], side), b = corner(nodes[i], side + 1);
            const Mesh::Corner c = corner(nodes[i + 1], side + 1), d = corner(nodes[i + 1], side);
            mesh.addTriangle({a, b, c});
            mesh.addTriangle({a, c, d});
        }
}

// Two triangles that share the midrib, folded a little along it.
void addLeaf(Mesh& mesh, const osg::Vec3d& stalk, const osg::Vec3d& tipDir, Random& random)
{
    const double length = random.between(0.05, 0.08); // [m] a birch's
    const osg::Vec3d acrossDir = unit(tipDir ^ random.inBall());
    const osg::Vec3d normal = acrossDir ^ tipDir;
    const osg::Vec3d middle = stalk + tipDir * (0.4 * length) + normal * (0.08 * length);
    const osg::Vec3d left = middle - acrossDir * (0.38 * length);
    const osg::Vec3d right = middle + acrossDir * (0.38 * length);
    const osg::Vec3d tip = stalk + tipDir * length;

    const float age = static_cast<float>(random.between(0.0, 1.0));
    // The sun shines through a leaf: its other side is hardly darker.
    const double light = AMBIENT + (1.0 - AMBIENT) * std::abs(normal * SUN_DIR);
    const osg::Vec3 colour = (YOUNG_LEAF * (1.0f - age) + OLD_LEAF * age) *
                             static_cast<float>(light * random.between(0.7, 1.1));
    const osg::Vec3 rib = colour * 0.85f;
    mesh.addTriangle({{{stalk, rib}, {right, colour}, {tip, rib}}});
    mesh.addTriangle({{{stalk, rib}, {tip, rib}, {left, colour}}});
}

// Leaves to both sides by turns; they hang.
void addLeaves(Mesh& mesh, const std::vector<Node>& nodes, Random& random)
{
    for (std::size_t i = 1; i < nodes.size(); ++i)
    {
        const osg::Vec3d acrossDir = unit(nodes[i].dir ^ random.inBall());
        for (double side : {-1.0, 1.0})
        {
            const osg::Vec3d dir = unit(acrossDir * side + nodes[i].dir * 0.5 +
                                        osg::Vec3d(0, 0, -0.7) + random.inBall() * 0.5);
            addLeaf(mesh, nodes[i].place + dir * STALK_LENGTH, dir, random);
        }
    }
}

void addTwig(Mesh& mesh, const Shoot& twig, int offspring, Random& random)
{
    const std::vector<Node> nodes = grow(twig, LEAF_SPACING, random);
    addWood(mesh, nodes, 3);
    addLeaves(mesh, nodes, random);
    for (int i = 0; i < offspring; ++i)
    {
        const Node& at = nodes[nodes.size() * (i + 1) / (offspring + 2)];
        const osg::Vec3d dir = unit(at.dir + random.inBall());
        addTwig(mesh,
                {at.place, dir, twig.length * random.between(0.4, 0.6), 0.5 * at.radius, TWIG_DROOP,
                 0.1},
                0, random);
    }
}

} // namespace

osg::ref_ptr<osg::Geode> osgwaterbench::createBough(const osg::Vec3d& eye)
{
    Random random;
    Mesh mesh;
    const std::vector<Node> limb = grow({eye + LIMB_FOOT, unit(osg::Vec3d(1.0, 0.04, 0.0)),
                                         LIMB_LENGTH, LIMB_RADIUS, LIMB_DROOP, 0.05},
                                        TWIG_SPACING, random);
    addWood(mesh, limb, 8);
    for (std::size_t i = BARE_LENGTH / TWIG_SPACING; i < limb.size(); ++i)
    {
        const double share = static_cast<double>(i) / limb.size();
        const osg::Vec3d dir = unit(limb[i].dir + random.inBall() * 1.3 + osg::Vec3d(0, 0, 0.25));
        addTwig(mesh,
                {limb[i].place, dir, random.between(0.6, 1.15) * (1.3 - 0.6 * share),
                 0.3 * limb[i].radius + 0.003, TWIG_DROOP, 0.08},
                TWIG_OFFSPRING, random);
    }

    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("bough");
    geode->addDrawable(mesh.takeGeometry());
    return geode;
}
