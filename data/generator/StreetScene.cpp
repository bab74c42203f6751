#include "StreetScene.h"

#include "Bake.h"
#include "Facade.h"
#include "Noise.h"
#include "Plants.h"
#include "Puddle.h"
#include "Shapes.h"
#include "Sky.h"
#include "StreetThings.h"
#include "WaterSurface.h"

#include <osg/Math>

#include <cmath>

namespace waterdata
{

namespace
{

const float streetEnd = 46.0f;
const float kerb = 3.6f;
const float houseFront = 7.0f;
const float pavementTop = 0.13f;

// Lines of a grid that is fine between the two limits and ever wider outside.
std::vector<float> gridLines(float low, float high, float fine, float end)
{
    std::vector<float> lines;
    for (float at = low; at < high; at += fine)
        lines.push_back(at);
    float step = fine;
    for (float at = high; at < end; at += step, step *= 1.25f)
        lines.push_back(at);
    lines.push_back(end);
    std::vector<float> before = {-end};
    for (float at = low - fine, wide = fine * 1.25f; at > -end; at -= wide, wide *= 1.25f)
        before.insert(before.begin() + 1, at);
    lines.insert(lines.begin(), before.begin(), before.end());
    return lines;
}

Mesh asphalt(const Puddle& puddle)
{
    Mesh mesh("asphalt");
    mesh.longestEdge = 0.0f;
    mesh.creaseAngle = 180.0f;
    const std::vector<float> columns = gridLines(-4.2f, 4.2f, 0.1f, streetEnd);
    const std::vector<float> rows = gridLines(-1.4f, kerb, 0.1f, kerb + 0.1f);
    const auto point = [&](float x, float y)
    {
        return osg::Vec3(x, y, puddle.asphaltHeight(osg::Vec2(x, y)));
    };
    const auto paint = [](const osg::Vec3& at)
    {
        const float worn = fractalNoise(at * 0.6f, 3);
        const float grit = noise(at * 9.0f);
        const float wet = smoothStep(0.010f, -0.004f, at.z());
        return shade(colour(0x77777a), (1.0f + 0.10f * worn + 0.03f * grit) * (1.0f - 0.42f * wet));
    };
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
    {
        for (std::size_t column = 0; column + 1 < columns.size(); ++column)
        {
            const osg::Vec3 a = point(columns[column], rows[row]);
            const osg::Vec3 b = point(columns[column + 1], rows[row]);
            const osg::Vec3 c = point(columns[column + 1], rows[row + 1]);
            const osg::Vec3 d = point(columns[column], rows[row + 1]);
            mesh.triangle(a, b, c, paint(a), paint(b), paint(c));
            mesh.triangle(a, c, d, paint(a), paint(c), paint(d));
        }
    }
    return mesh;
}

// Kerb stones and paving slabs on both sides of the street.
Mesh pavement()
{
    Mesh mesh("pavement");
    mesh.longestEdge = 0.7f;
    Random random(17);
    for (float side : {-1.0f, 1.0f})
    {
        for (float x = -streetEnd; x < streetEnd; x += 1.0f)
        {
            const float near = side > 0.0f ? kerb : -kerb - 0.25f;
            addBox(mesh, {x, near, -0.05f}, {x + 0.985f, near + 0.25f, pavementTop},
                   shade(colour(0xa9a49b), random.between(0.92f, 1.06f)));
            for (float out = kerb + 0.25f; out < houseFront - 0.3f; out += 0.8f)
            {
                const float y = side > 0.0f ? out : -out - 0.8f;
                mesh.quad({x, y, pavementTop}, {x + 1.0f, y, pavementTop},
                          {x + 1.0f, y + 0.8f, pavementTop}, {x, y + 0.8f, pavementTop},
                          shade(colour(0xbdb3a2), random.between(0.9f, 1.05f)));
            }
        }
    }
    return mesh;
}

Mesh roadMarks()
{
    Mesh mesh("road marks");
    for (float x = -streetEnd; x < streetEnd; x += 3.0f)
    {
        if (std::fabs(x + 0.6f) > 4.0f)
            addBox(mesh, {x, -0.9f, -0.01f}, {x + 1.4f, -0.78f, 0.022f}, colour(0xe4e0d4));
    }
    return mesh;
}

std::vector<FacadeStyle> facadeStyles()
{
    std::vector<FacadeStyle> styles(7);
    styles[0].wall = colour(0x9fb3a5);
    styles[0].shop = colour(0x7a3b2c);
    styles[0].hasAwning = false;
    styles[1].wall = colour(0xe2c27a);
    styles[1].width = 7.2f;
    styles[1].awning = colour(0x2f6b52);
    styles[1].gabled = true;
    styles[2].wall = colour(0xb5523f);
    styles[2].width = 6.2f;
    styles[2].storeys = 4;
    styles[2].shop = colour(0x2b3d55);
    styles[2].awning = colour(0x27508a);
    styles[2].roof = colour(0x4d5157);
    styles[3].wall = colour(0xefe6d2);
    styles[3].width = 7.6f;
    styles[3].windows = 4;
    styles[3].shop = colour(0x8a2f2a);
    styles[3].trim = colour(0xb9ab92);
    styles[4].wall = colour(0x86a4bd);
    styles[4].width = 6.4f;
    styles[4].gabled = true;
    styles[4].shop = colour(0x4a3b2b);
    styles[4].hasAwning = false;
    styles[4].roof = colour(0x55493f);
    styles[5].wall = colour(0xd79a6a);
    styles[5].storeys = 4;
    styles[5].awning = colour(0xc78f2c);
    styles[6].wall = colour(0xcfd0c4);
    styles[6].gabled = true;
    return styles;
}

Mesh placedMesh(const char* name, const osg::Vec3& place, float turn, float longestEdge)
{
    Mesh mesh(name);
    mesh.longestEdge = longestEdge;
    mesh.frame = osg::Matrixd::rotate(osg::DegreesToRadians(turn), osg::Z_AXIS)
               * osg::Matrixd::translate(place);
    return mesh;
}

void addFacades(std::vector<Mesh>& meshes)
{
    float x = -22.5f;
    for (const FacadeStyle& style : facadeStyles())
    {
        Mesh walls = placedMesh("house walls", {x, houseFront, pavementTop}, 0.0f, 0.45f);
        Mesh details = placedMesh("house details", {x, houseFront, pavementTop}, 0.0f, 1.3f);
        addFacade(walls, details, style);
        meshes.push_back(walls);
        meshes.push_back(details);
        x += style.width;
    }
}

void addThings(std::vector<Mesh>& meshes, const Puddle& puddle)
{
    meshes.push_back(placedMesh("car", {6.6f, 2.45f, 0.014f}, 180.0f, 0.18f));
    addCar(meshes.back(), colour(0xc23b2e));
    meshes.push_back(placedMesh("second car", {-13.5f, 2.5f, 0.014f}, 0.0f, 0.3f));
    addCar(meshes.back(), colour(0x4f7f8f));
    meshes.push_back(placedMesh("bicycle", {-3.3f, 6.62f, pavementTop}, 4.0f, 0.0f));
    addBicycle(meshes.back(), colour(0x2f8f86));
    meshes.push_back(placedMesh("bin", {3.5f, 4.5f, pavementTop}, 0.0f, 0.25f));
    addBin(meshes.back());
    for (float x : {-1.6f, -18.0f, 16.0f})
    {
        meshes.push_back(placedMesh("lamp", {x, 4.15f, pavementTop}, 0.0f, 0.35f));
        addLamp(meshes.back());
    }
    for (float x : {-5.6f, -3.4f, -1.2f, 1.0f, 3.2f})
    {
        const float y = 1.75f;
        const float ground = puddle.asphaltHeight(osg::Vec2(x, y));
        meshes.push_back(placedMesh("bollard", {x, y, ground}, 0.0f, 0.15f));
        addBollard(meshes.back());
    }
}

// Grass and trees on the other side, beyond the street's ends and behind the houses.
void addPark(std::vector<Mesh>& meshes)
{
    const float far = 170.0f;
    Mesh lawn("lawn");
    lawn.longestEdge = 3.0f;
    const auto meadow = [&lawn](float left, float low, float right, float high)
    {
        lawn.quad({left, low, 0.05f}, {right, low, 0.05f}, {right, high, 0.05f},
                  {left, high, 0.05f}, colour(0x76894a));
    };
    meadow(-far, -far, far, 0.2f - houseFront);
    meadow(-far, 0.2f - houseFront, -streetEnd, houseFront);
    meadow(streetEnd, 0.2f - houseFront, far, houseFront);
    meadow(-far, houseFront - 0.3f, far, far);
    meshes.push_back(lawn);

    Mesh trees("park trees");
    trees.longestEdge = 0.0f;
    trees.creaseAngle = 70.0f;
    trees.leafy = true;
    Random random(29);
    for (int tree = 0; tree < 150; ++tree)
    {
        const float angle = random.angle();
        const float distance = random.between(38.0f, 120.0f);
        const osg::Vec3 foot(distance * std::cos(angle), 0.8f * distance * std::sin(angle), 0.0f);
        const bool onStreet = std::fabs(foot.y()) < 9.0f && std::fabs(foot.x()) < streetEnd + 4.0f;
        const bool inHouses = foot.y() > 0.0f && foot.y() < 20.0f && std::fabs(foot.x()) < 30.0f;
        if (onStreet || inHouses || (foot.y() < 0.0f && std::fabs(foot.x()) < 34.0f))
            continue;
        const Placed placed(trees, foot, random.between(0.0f, 360.0f));
        addBroadleaf(trees, random, random.between(8.0f, 14.0f), distance < 62.0f ? 2 : 1);
    }
    meshes.push_back(trees);
}

}

osg::ref_ptr<osg::Group> streetScene(const std::string& dataDirectory)
{
    const Puddle puddle(osg::Vec2(-0.6f, 1.5f));
    std::vector<Mesh> meshes;
    addFacades(meshes);
    addThings(meshes, puddle);
    addPark(meshes);
    meshes.push_back(asphalt(puddle));
    meshes.push_back(pavement());
    meshes.push_back(roadMarks());

    const osg::Vec3 focus(-1.0f, -5.0f, 1.6f);
    osg::ref_ptr<osg::Group> scene = bakeScene(std::move(meshes), afternoon(), focus);
    scene->setName("street");
    scene->addChild(waterSurface(puddle.waterOutline()));
    scene->addChild(skyBox(dataDirectory, 100.0f));
    return scene;
}

}
