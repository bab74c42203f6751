#include "DepthCells.h"

#include "../shaders/Bindings.h"

using namespace osgWaterReflect;

namespace
{

// As in shaders/interface.glsl.
const int CELL = 4;
const int CELLS_MERGED = 8;

const char* const FIND_BOUNDS = "pyramid_cells.frag";
const char* const MERGE = "pyramid_merge.frag";
const char* const PACK = "pyramid_pack.frag";

glm::ivec2 cellsOver(const glm::ivec2& size, int side)
{
    return (size + side - 1) / side;
}

} // namespace

DepthCells::DepthCells() :
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

std::vector<osg::ref_ptr<osg::Program>> DepthCells::programs()
{
    return {ImagePass::program(FIND_BOUNDS), ImagePass::program(MERGE), ImagePass::program(PACK)};
}

void DepthCells::compute(const Capture& capture)
{
    _smallest->setInput(0, bindings::PYRAMID_SOURCE, capture.windowZ());
    glm::ivec2 sourceSize = capture.size();
    glm::ivec2 capacity = capture.capacity();
    const auto build = [&](ImagePass& pass, int side)
    {
        bindings::set(pass.stateSet(), bindings::PYRAMID_SOURCE_SIZE,
                      osg::Vec2(sourceSize.x, sourceSize.y));
        sourceSize = cellsOver(sourceSize, side);
        capacity = cellsOver(capacity, side);
        pass.require(capture.stage(), sourceSize, capacity);
    };
    build(*_smallest, CELL);
    const glm::ivec2 cells = sourceSize;
    const glm::ivec2 cellCapacity = capacity;
    build(*_middle, CELLS_MERGED);
    build(*_large, CELLS_MERGED);
    _cells->require(capture.stage(), cells, cellCapacity);
}

void DepthCells::releaseGLObjects(osg::State* state) const
{
    for (const auto& pass : {_smallest, _middle, _large, _cells})
        pass->releaseGLObjects(state);
}

void DepthCells::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (const auto& pass : {_smallest, _middle, _large, _cells})
        pass->resizeGLObjectBuffers(maxSize);
}
