#include "Boxes.h"

#include "Mesh.h"

#include "osgwaterviewer/DemoScenes.h"

#include <osgWaterReflect/Check.h>

#include <osg/Math>
#include <osgDB/FileNameUtils>

#include <nlohmann/json.hpp>

#include <fstream>

using namespace osgwaterbench;
using nlohmann::json;

namespace
{

const float BLUE = 0.5f;                            // the file gives red and green
const osg::Vec3 BRANCH_COLOUR(0.45f, 0.32f, 0.25f); // the file gives none; no box is brown

osg::Vec3d toVec3d(const json& numbers)
{
    return osg::Vec3d(numbers.at(0), numbers.at(1), numbers.at(2));
}

Box toBox(const json& box, const osg::Vec3& colour)
{
    return {toVec3d(box.at("min")), toVec3d(box.at("max")), colour};
}

BoxesFile toBoxesFile(const json& root)
{
    BoxesFile file;
    const json& camera = root.at("camera");
    file.eye = toVec3d(camera.at("eye"));
    file.pitch = camera.at("pitch_rad");
    file.fovyDegrees =
        osg::RadiansToDegrees(2.0 * camera.at("half_vertical_fov_rad").get<double>());
    for (const json& term : root.at("wave_terms"))
        file.waves.push_back({osg::Vec2d(term.at("d").at(0), term.at("d").at(1)), term.at("k"),
                              term.at("phi"), term.at("w")});
    for (const json& box : root.at("boxes"))
        file.boxes.push_back(
            toBox(box, osg::Vec3(box.at("colour").at(0), box.at("colour").at(1), BLUE)));
    file.branch = toBox(root.at("branch"), BRANCH_COLOUR);
    return file;
}

} // namespace

std::optional<BoxesFile> BoxesFile::read()
{
    const std::string path =
        osgDB::concatPaths(osgwaterviewer::dataDirectory(), "bench/boxes.json");
    std::ifstream stream(path);
    const std::string expected = "boxes in " + path;
    if (!stream)
    {
        osgWaterReflect::refuse("BoxesFile::read", expected.c_str(), "none that can be read");
        return std::nullopt;
    }
    try
    {
        return toBoxesFile(json::parse(stream));
    }
    catch (const json::exception& error)
    {
        osgWaterReflect::refuse("BoxesFile::read", expected.c_str(), error.what());
        return std::nullopt;
    }
}

osg::ref_ptr<osg::Geode> osgwaterbench::createBoxes(const std::vector<Box>& boxes)
{
    Mesh mesh;
    for (const Box& box : boxes)
        mesh.addBox(box.lowest, box.highest, box.colour);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("boxes");
    geode->addDrawable(mesh.takeGeometry());
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, createChequers());
    return geode;
}
