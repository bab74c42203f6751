#include "Pyramid.h"

#include "../trace/Bindings.h"

using namespace osgWaterReflect;

namespace
{

// As in shaders/interface.glsl.
const int CELL = 4;
const int CELLS_MERGED = 8;

const char* const FIND_BOUNDS = "pyramid_cells.frag";
const char* const MERGE = "pyramid_merge.frag";
const char* const PACK = "pyramid_pack.frag";

int cellsOver(int length, int side)
{
    return (length + side - 1) / side;
}

} // namespace

Pyramid::Pyramid() :
    _smallest(new ImagePass(FIND_BOUNDS, GL_RG32F, GL_RG)),
    _middle(new ImagePass(MERGE, GL_R32F, GL_RED)), _large(new ImagePass(MERGE, GL_R32F, GL_RED)),
    _cells(new ImagePass(PACK, GL_RGBA32F_ARB, GL_RGBA))
{
    _middle->setInput(0, bindings::PYRAMID_SOURCE, _smallest->image());
    _large->setInput(0, bindings::PYRAMID_SOURCE, _middle->image());
    _cells->setInput(0, bindings::PYRAMID_SOURCE, _smallest->image());
    _cells->setInput(1, bindings::PYRAMID_MIDDLE, _middle->image());
    _cells->setInput(2, bindings::PYRAMID_LARGE, _large->image());
}

std::vector<osg::ref_ptr<osg::Program>> Pyramid::programs()
{
    return {ImagePass::program(FIND_BOUNDS), ImagePass::program(MERGE), ImagePass::program(PACK)};
}

void Pyramid::require(osgUtil::CullVisitor& view, const Capture& capture)
{
    if (_serial == capture.serial()) return;
    _serial = capture.serial();

    osg::Texture2D* const windowZ = capture.windowZ();
    _smallest->setInput(0, bindings::PYRAMID_SOURCE, windowZ);
    const int width = cellsOver(windowZ->getTextureWidth(), CELL);
    const int height = cellsOver(windowZ->getTextureHeight(), CELL);
    const int middleWidth = cellsOver(width, CELLS_MERGED);
    const int middleHeight = cellsOver(height, CELLS_MERGED);
    _smallest->require(view, width, height);
    _middle->require(view, middleWidth, middleHeight);
    _large->require(view, cellsOver(middleWidth, CELLS_MERGED),
                    cellsOver(middleHeight, CELLS_MERGED));
    _cells->require(view, width, height);
}

void Pyramid::releaseGLObjects(osg::State* state) const
{
    for (const auto& pass : {_smallest, _middle, _large, _cells})
        pass->releaseGLObjects(state);
}

void Pyramid::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (const auto& pass : {_smallest, _middle, _large, _cells})
        pass->resizeGLObjectBuffers(maxSize);
}
