#ifndef OSGWATERREFLECT_PASSES_GLOBJECTS_H
#define OSGWATERREFLECT_PASSES_GLOBJECTS_H

#include <osg/Referenced>
#include <osg/State>

namespace osgWaterReflect
{

/// What holds objects of OpenGL for a view: to be released, and resized, with all others of it.
class GLObjects : public osg::Referenced
{
public:
    /// In one context; in all of them where the state is null.
    virtual void releaseGLObjects(osg::State* state) const = 0;

    /// Makes room for as many contexts.
    virtual void resizeGLObjectBuffers(unsigned int maxSize) = 0;
};

} // namespace osgWaterReflect

#endif
