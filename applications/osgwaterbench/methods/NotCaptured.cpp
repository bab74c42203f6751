#include "NotCaptured.h"

#include <osgWaterReflect/capture/CaptureVisitor.h>

using namespace osgwaterbench;

void NotCaptured::operator()(osg::Node* node, osg::NodeVisitor* visitor)
{
    if (!dynamic_cast<osgWaterReflect::CaptureVisitor*>(visitor)) traverse(node, visitor);
}
