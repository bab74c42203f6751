#ifndef OSGWATERBENCH_NOTCAPTURED_H
#define OSGWATERBENCH_NOTCAPTURED_H

#include <osg/Callback>

namespace osgwaterbench
{

/// A cull callback that keeps what is below its node out of the water's captures, for methods that
/// do not search them: what remains of a capture is an image cleared.
class NotCaptured : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override;
};

} // namespace osgwaterbench

#endif
