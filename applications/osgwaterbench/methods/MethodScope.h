#ifndef OSGWATERBENCH_METHODSCOPE_H
#define OSGWATERBENCH_METHODSCOPE_H

#include "Methods.h"
#include "NotCaptured.h"

#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/shaders/ShaderSource.h>

#include <osg/Group>
#include <osg/Program>

#include <list>
#include <set>

namespace osgwaterbench
{

/// What methods are tried on: water, the scene it reflects, and a mirrored camera above that scene,
/// side by side below the view.
struct TestBed
{
    osg::ref_ptr<osgWaterReflect::WaterSurface> water;
    osg::ref_ptr<osg::Group> scene;    ///< without the water
    osg::ref_ptr<MirrorCamera> mirror; ///< may be null where no method needs one; the caller has
                                       ///< it follow the view

    /// Of all that were tried, so that trying one again compiles nothing. The library keeps them
    /// only while some water is drawn by them.
    std::set<osg::ref_ptr<osg::Program>> programs;
};

/// A method at work while it lives: what is culled meanwhile is drawn by it. The mirrored camera is
/// rendered only for a method that looks into it. One at a time.
///
/// The water's settings are the method's until another's: they are not put back.
class MethodScope
{
public:
    /// Throws std::runtime_error where the method needs a mirrored camera and there is none.
    MethodScope(const Method& method, TestBed& bed);
    ~MethodScope();
    MethodScope(const MethodScope&) = delete;
    MethodScope& operator=(const MethodScope&) = delete;

private:
    TestBed& _bed;
    std::list<osgWaterReflect::ShaderReplacement> _replacements;
    osg::ref_ptr<NotCaptured> _notCaptured; // null where the method uses the capture
};

} // namespace osgwaterbench

#endif
