#ifndef OSGWATERBENCH_READBACK_H
#define OSGWATERBENCH_READBACK_H

#include "../measures/Drawn.h"
#include "BenchView.h"

namespace osgwaterbench
{

/// What a view draws at its pixels of water, whatever the method. Two frames are rendered; the
/// method has to be one of the library's own, with a capture of the view's size.
DrawnWater readDrawnWater(BenchView& view);

/// The first image that the last frame was searched in.
osgWaterReflect::reference::CapturedImage readCapture(BenchView& view);

/// What the view's method answers at each pixel. One frame is rendered.
Answers readAnswers(BenchView& view);

} // namespace osgwaterbench

#endif
