#include "StreetThings.h"

#include "Shapes.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

namespace
{

const Colour iron = colour(0x33383b);
const Colour rubber = colour(0x2a2a2c);

// Joins the sections of a body, each a rectangle across the car at some x, with bevelled edges.
struct Section
{
    float x;
    float low;
    float high;
    float half;
};

void addSections(Mesh& mesh, const std::vector<Section>& sections, const Colour& paint)
{
    const float bevel = 0.12f;
    const auto outline = [bevel](const Section& s)
    {
        const float cut = std::min(bevel, 0.4f * (s.high - s.low));
        return std::vector<osg::Vec3>{
            {s.x, -s.half + cut, s.low}, {s.x, -s.half, s.low + cut}, {s.x, -s.half, s.high - cut},
            {s.x, -s.half + cut, s.high}, {s.x, s.half - cut, s.high}, {s.x, s.half, s.high - cut},
            {s.x, s.half, s.low + cut}, {s.x, s.half - cut, s.low}};
    };
    for (std::size_t index = 0; index + 1 < sections.size(); ++index)
    {
        const std::vector<osg::Vec3> here = outline(sections[index]);
        const std::vector<osg::Vec3> next = outline(sections[index + 1]);
        for (std::size_t edge = 0; edge < 8; ++edge)
        {
            const std::size_t other = (edge + 1) % 8;
            mesh.quad(next[edge], next[other], here[other], here[edge], paint);
        }
    }
    const std::vector<osg::Vec3> back = outline(sections.front());
    const std::vector<osg::Vec3> front = outline(sections.back());
    for (std::size_t corner = 1; corner + 1 < 8; ++corner)
    {
        mesh.triangle(back[0], back[corner], back[corner + 1], paint);
        mesh.triangle(front[0], front[corner + 1], front[corner], paint);
    }
}

void addWheel(Mesh& mesh, const osg::Vec3& centre, float side)
{
    const Placed placed(mesh, osg::Matrixd::rotate(-side * osg::PI_2, osg::X_AXIS)
                                  * osg::Matrixd::translate(centre));
    addTurned(mesh,
              {{0.0f, -0.18f},
               {0.30f, -0.18f},
               {0.33f, -0.13f},
               {0.33f, 0.03f},
               {0.30f, 0.06f},
               {0.20f, 0.06f},
               {0.19f, 0.04f},
               {0.05f, 0.07f},
               {0.0f, 0.07f}},
              20, [](int row, int) { return row < 5 ? rubber : colour(0xc3c6c8); });
}

}

void addCar(Mesh& mesh, const Colour& paint)
{
    addSections(mesh, {{-1.92f, 0.42f, 0.72f, 0.66f}, {-1.82f, 0.30f, 0.86f, 0.76f},
                       {-1.20f, 0.24f, 0.92f, 0.81f}, {0.75f, 0.24f, 0.90f, 0.81f},
                       {1.55f, 0.26f, 0.80f, 0.77f}, {1.85f, 0.32f, 0.66f, 0.68f},
                       {1.92f, 0.40f, 0.58f, 0.60f}}, paint);
    const Colour glass = colour(0x54697a);
    addSections(mesh, {{-1.62f, 0.84f, 0.93f, 0.72f}, {-1.12f, 0.84f, 1.40f, 0.61f},
                       {0.12f, 0.84f, 1.44f, 0.62f}, {0.86f, 0.84f, 0.93f, 0.72f}}, glass);
    addSections(mesh, {{-1.20f, 1.36f, 1.44f, 0.60f}, {-0.5f, 1.40f, 1.50f, 0.60f},
                       {0.18f, 1.36f, 1.46f, 0.60f}}, paint);
    for (float side : {-1.0f, 1.0f})
    {
        for (float pillar : {-1.16f, -0.42f, 0.16f})
            addSlab(mesh, {pillar - 0.05f, side * 0.63f, 1.38f},
                    {pillar + 0.05f, side * 0.63f, 1.38f}, {pillar + 0.07f, side * 0.74f, 0.88f},
                    {pillar - 0.07f, side * 0.74f, 0.88f}, {0.0f, side * -0.03f, 0.0f}, paint);
        for (float axle : {-1.2f, 1.18f})
            addWheel(mesh, {axle, side * 0.74f, 0.33f}, side);
        addBall(mesh, {1.83f, side * 0.52f, 0.58f}, {0.08f, 0.13f, 0.10f}, 12, colour(0xf4f1e0));
        addBox(mesh, {-1.93f, side * 0.56f - 0.10f, 0.58f}, {-1.84f, side * 0.56f + 0.10f, 0.74f},
               colour(0xb02420));
    }
    addBox(mesh, {1.80f, -0.62f, 0.34f}, {1.97f, 0.62f, 0.44f}, colour(0xc9ccce));
    addBox(mesh, {-1.97f, -0.62f, 0.36f}, {-1.80f, 0.62f, 0.46f}, colour(0xc9ccce));
}

void addBicycle(Mesh& mesh, const Colour& paint)
{
    const osg::Vec3 rear(-0.52f, 0.0f, 0.34f), front(0.54f, 0.0f, 0.34f),
        pedal(-0.06f, 0.0f, 0.29f);
    const osg::Vec3 seat(-0.22f, 0.0f, 0.86f), head(0.36f, 0.0f, 0.84f), bar(0.33f, 0.0f, 0.98f);
    for (const osg::Vec3& hub : {rear, front})
    {
        const Placed wheel(mesh, osg::Matrixd::rotate(osg::PI_2, osg::X_AXIS)
                                     * osg::Matrixd::translate(hub));
        addRing(mesh, 0.325f, 0.018f, 28, rubber);
        for (int spoke = 0; spoke < 8; ++spoke)
        {
            const float angle = osg::PIf * static_cast<float>(spoke) / 4.0f;
            addTube(mesh, {0.0f, 0.0f, 0.0f},
                    {0.32f * std::cos(angle), 0.32f * std::sin(angle), 0.0f}, 0.004f, 0.004f, 3,
                    colour(0xb9bcbe));
        }
    }
    const std::pair<osg::Vec3, osg::Vec3> frame[] = {{rear, pedal}, {rear, seat}, {pedal, seat},
                                                     {pedal, head}, {seat, head}, {head, front},
                                                     {head, bar}};
    for (const auto& [from, to] : frame)
        addTube(mesh, from, to, 0.017f, 0.017f, 6, paint);
    addTube(mesh, bar - osg::Vec3(0.0f, 0.27f, 0.0f), bar + osg::Vec3(0.0f, 0.27f, 0.0f), 0.013f,
            0.013f, 6, iron);
    addTube(mesh, seat, seat + osg::Vec3(-0.02f, 0.0f, 0.10f), 0.014f, 0.014f, 6, iron);
    addBall(mesh, seat + osg::Vec3(-0.04f, 0.0f, 0.12f), {0.13f, 0.07f, 0.035f}, 12,
            colour(0x5c3d2a));
    addTube(mesh, pedal, pedal + osg::Vec3(0.10f, -0.08f, -0.12f), 0.012f, 0.012f, 5, iron);
    addTube(mesh, pedal, pedal + osg::Vec3(-0.10f, 0.08f, 0.12f), 0.012f, 0.012f, 5, iron);
    const Placed basket(mesh, bar + osg::Vec3(0.16f, 0.0f, -0.16f));
    addBox(mesh, {-0.12f, -0.16f, 0.0f}, {0.14f, 0.16f, 0.2f}, colour(0xb08a55));
}

void addLamp(Mesh& mesh)
{
    addTurned(mesh, {{0.0f, 0.0f}, {0.19f, 0.0f}, {0.19f, 0.1f}, {0.13f, 0.2f}, {0.12f, 0.8f},
                     {0.075f, 0.9f}, {0.05f, 3.5f}, {0.09f, 3.54f}, {0.05f, 3.6f}, {0.05f, 3.75f},
                     {0.0f, 3.76f}}, 12, [](int, int) { return iron; });
    addTube(mesh, {-0.38f, 0.0f, 3.3f}, {0.38f, 0.0f, 3.3f}, 0.02f, 0.02f, 6, iron);
    addTurned(mesh, {{0.0f, 3.75f}, {0.13f, 3.75f}, {0.22f, 4.25f}, {0.0f, 4.26f}}, 6,
              [](int, int) { return colour(0xf6e9b8); });
    addTurned(mesh, {{0.0f, 4.24f}, {0.27f, 4.25f}, {0.08f, 4.48f}, {0.03f, 4.62f}, {0.0f, 4.64f}},
              6, [](int, int) { return iron; });
}

void addBollard(Mesh& mesh)
{
    addTurned(mesh,
              {{0.0f, -0.1f},
               {0.085f, -0.1f},
               {0.075f, 0.62f},
               {0.09f, 0.64f},
               {0.09f, 0.72f},
               {0.075f, 0.74f},
               {0.07f, 0.84f},
               {0.05f, 0.89f},
               {0.0f, 0.91f}},
              16, [](int row, int) { return row == 3 ? colour(0xe9e4d8) : colour(0x9c2f28); });
}

void addBin(Mesh& mesh)
{
    addTurned(mesh, {{0.0f, 0.02f}, {0.22f, 0.02f}, {0.27f, 0.85f}, {0.29f, 0.86f}, {0.29f, 0.93f},
                     {0.24f, 0.93f}, {0.22f, 0.7f}, {0.0f, 0.7f}}, 18,
              [](int row, int) { return row < 2 ? colour(0x3f6b4c) : colour(0x2d4c38); });
}

}
