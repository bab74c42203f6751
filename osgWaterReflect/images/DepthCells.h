#ifndef OSGWATERREFLECT_IMAGES_DEPTHCELLS_H
#define OSGWATERREFLECT_IMAGES_DEPTHCELLS_H

#include "../capture/Capture.h"
#include "../passes/ImagePass.h"

#include <osg/Program>

#include <vector>

namespace osgWaterReflect
{

/// How near the surface comes that a capture shows, in cells of three sizes: so that a search can
/// pass over what its ray does not reach.
///
/// | image    | format  | a texel holds                                   | side of its cell [px] |
/// |----------|---------|-------------------------------------------------|-----------------------|
/// | smallest | RG32F   | nearest and farthest windowZ                    | 4                     |
/// | middle   | R32F    | nearest windowZ                                 | 32                    |
/// | large    | R32F    | the same                                        | 256                   |
/// | cells    | RGBA32F | nearest of the smallest, middle and large cell about it, and the farthest
/// of the smallest | 4 |
///
/// Sizes are rounded up: a cell at the border may hold fewer pixels. Background counts as farthest,
/// 1. Only what is rendered is held here, nothing of any water's settings.
class DepthCells : public GLObjects
{
public:
    DepthCells();

    /// Computes them as soon as the capture is rendered.
    void compute(const Capture& capture);

    /// All that computing them runs, for those who compile ahead.
    static std::vector<osg::ref_ptr<osg::Program>> programs();

    /// What a search reads.
    osg::Texture2D* cells() const { return _cells->image(); }

    void releaseGLObjects(osg::State* state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

private:
    osg::ref_ptr<ImagePass> _smallest;
    osg::ref_ptr<ImagePass> _middle;
    osg::ref_ptr<ImagePass> _large;
    osg::ref_ptr<ImagePass> _cells;
};

} // namespace osgWaterReflect

#endif
