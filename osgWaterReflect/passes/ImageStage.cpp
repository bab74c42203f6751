#include "ImageStage.h"

using namespace osgWaterReflect;

namespace
{

// Covers the whole target.
osg::ref_ptr<osg::Geometry> createTriangle()
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& corner : {osg::Vec3(-1, -1, 0), {3, -1, 0}, {-1, 3, 0}})
        corners->push_back(corner);
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    triangle->setVertexArray(corners);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    triangle->setUseDisplayList(false);
    triangle->setUseVertexBufferObjects(true);
    return triangle;
}

} // namespace

ImageStage::ImageStage() :
    _stateSet(new osg::StateSet), _triangle(createTriangle()), _stateGraph(new osgUtil::StateGraph)
{
    for (const GLenum mode : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE})
        _stateSet->setMode(mode, osg::StateAttribute::OFF);

    setViewport(new osg::Viewport);
    // Without it in the state, OSG falls back to the size that its viewports are made with.
    _stateSet->setAttribute(getViewport());
    setColorMask(new osg::ColorMask);
    setClearMask(0);
    const osg::ref_ptr<osg::RefMatrix> identity = new osg::RefMatrix;
    setInitialViewMatrix(identity);
}

void ImageStage::prepare(int x, int y, int width, int height)
{
    getViewport()->setViewport(x, y, width, height);

    // OSG would reset the stages of the last frame before and after it, too, and one of them may
    // hold what it is to draw in this frame already.
    getPreRenderList().clear();
    getPostRenderList().clear();
    reset();
    _stateGraph->clean();
    osgUtil::StateGraph* const leaves = _stateGraph->find_or_insert(_stateSet);
    const osg::ref_ptr<osg::RefMatrix> identity = new osg::RefMatrix;
    leaves->addLeaf(new osgUtil::RenderLeaf(_triangle, identity, identity));
    addStateGraph(leaves);
    sort();
}

void ImageStage::releaseGLObjects(osg::State* state) const
{
    _stateSet->releaseGLObjects(state);
    _triangle->releaseGLObjects(state);
    // osg::State does not set arrays again that it has set last, though their buffer be gone.
    _triangle->getVertexArray()->dirty();
    osgUtil::RenderStage::releaseGLObjects(state);
}

void ImageStage::resizeGLObjectBuffers(unsigned int maxSize)
{
    _stateSet->resizeGLObjectBuffers(maxSize);
    _triangle->resizeGLObjectBuffers(maxSize);
    osgUtil::RenderStage::resizeGLObjectBuffers(maxSize);
}
