#include "CullScene.h"

#include <osg/Geometry>
#include <osg/Material>
#include <osg/Math>
#include <osg/MatrixTransform>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

using namespace osgwaterbench;
using osgWaterReflect::WaterSurface;

namespace
{

// [m] The field: the eye is at (0, 0), looks along y, and leaves out what is behind and beside it.
const double LEFT = -100.0;
const double RIGHT = 100.0;
const double NEAREST = -30.0;
const double FARTHEST = 270.0;

const osg::Vec3 BOX_SIZE(1.0f, 1.0f, 2.0f); // [m]
// By corner: bit 0 is to the right, bit 1 behind, bit 2 above.
const GLubyte BOX_FACES[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                             1, 3, 7, 5, 3, 2, 6, 7, 2, 0, 4, 6};
const std::size_t SHARED_STATE_SETS = 8;

// [m] The small waters' grid, in view from every place of the eye, and what each fills of its cell.
const int GRID = 8; // waters along each side
const double GRID_LEFT = -16.0;
const double GRID_RIGHT = 16.0;
const double GRID_NEAREST = 40.0;
const double GRID_FARTHEST = 280.0;
const double FILLED = 0.9;
const double STEP_UP = 0.05; // [m] from level to level: the highest stays well below the eye

const osg::Vec3d EYE(0.0, 0.0, 8.0); // [m]
const double FOVY_DEGREES = 46.0;
const double DROP = 0.12;                       // [1] how far the line of sight falls on its way
const double STEP = 0.1;                        // [m] forward: 6 m/s at 60 frames a second
const double TURN = osg::DegreesToRadians(0.1); // [rad] a step
const int STEPS_ONE_WAY = 25;

osg::ref_ptr<osg::Vec3Array> createBoxCorners()
{
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (int i = 0; i < 8; ++i)
        corners->push_back(osg::Vec3(BOX_SIZE.x() * ((i & 1) - 0.5f),
                                     BOX_SIZE.y() * ((i >> 1 & 1) - 0.5f),
                                     BOX_SIZE.z() * (i >> 2)));
    return corners;
}

osg::ref_ptr<osg::StateSet> createColour(float red)
{
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4(red, 0.5f, 0.5f, 1.0f));
    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(material);
    return stateSet;
}

osg::ref_ptr<WaterSurface> createRectangle(double x, double y, double z, double length,
                                           double width)
{
    return WaterSurface::createRectangle(osg::Vec3(x, y, z), osg::Vec3(length, 0, 0),
                                         osg::Vec3(0, width, 0));
}

} // namespace

osg::ref_ptr<osg::Group> osgwaterbench::createBoxField(std::size_t drawables, BoxStates states)
{
    const osg::ref_ptr<osg::Vec3Array> corners = createBoxCorners();
    const osg::ref_ptr<osg::DrawElementsUByte> faces =
        new osg::DrawElementsUByte(GL_QUADS, std::size(BOX_FACES), BOX_FACES);
    const std::size_t stateSets =
        states == BoxStates::OWN ? drawables : std::min(drawables, SHARED_STATE_SETS);
    std::vector<osg::ref_ptr<osg::StateSet>> colours;
    for (std::size_t i = 0; i < stateSets; ++i)
        colours.push_back(createColour(static_cast<float>(i) / stateSets));

    const osg::ref_ptr<osg::Group> field = new osg::Group;
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(drawables)));
    const std::size_t rows = (drawables + columns - 1) / columns;
    for (std::size_t i = 0; i < drawables; ++i)
    {
        const osg::ref_ptr<osg::Geometry> box = new osg::Geometry;
        box->setVertexArray(corners);
        box->addPrimitiveSet(faces);
        box->setStateSet(colours[i % stateSets]);
        const double x = LEFT + (RIGHT - LEFT) * (i % columns + 0.5) / columns;
        const double y = NEAREST + (FARTHEST - NEAREST) * (i / columns + 0.5) / rows;
        const osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrix::translate(x, y, 0.0));
        place->addChild(box);
        field->addChild(place);
    }
    return field;
}

std::vector<osg::ref_ptr<WaterSurface>> osgwaterbench::createFieldWaters(WaterLayout layout)
{
    if (layout == WaterLayout::ONE)
        return {createRectangle(0.5 * (LEFT + RIGHT), 0.5 * (NEAREST + FARTHEST), 0.0, RIGHT - LEFT,
                                FARTHEST - NEAREST)};
    const double length = (GRID_RIGHT - GRID_LEFT) / GRID;
    const double width = (GRID_FARTHEST - GRID_NEAREST) / GRID;
    const double stepUp = layout == WaterLayout::ON_LEVELS ? STEP_UP : 0.0;
    std::vector<osg::ref_ptr<WaterSurface>> waters;
    for (int row = 0; row < GRID; ++row)
        for (int column = 0; column < GRID; ++column)
            waters.push_back(createRectangle(
                GRID_LEFT + (column + 0.5) * length, GRID_NEAREST + (row + 0.5) * width,
                stepUp * static_cast<double>(waters.size()), FILLED * length, FILLED * width));
    return waters;
}

FieldEye osgwaterbench::fieldEye(int steps)
{
    const int ahead = std::abs((steps + STEPS_ONE_WAY) % (2 * STEPS_ONE_WAY) - STEPS_ONE_WAY);
    const double heading = ahead * TURN;
    const osg::Vec3d eye = EYE + osg::Vec3d(0.0, ahead * STEP, 0.0);
    return {eye, eye + osg::Vec3d(std::sin(heading), std::cos(heading), -DROP), FOVY_DEGREES};
}
