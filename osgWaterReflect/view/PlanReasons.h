#ifndef OSGWATERREFLECT_VIEW_PLANREASONS_H
#define OSGWATERREFLECT_VIEW_PLANREASONS_H

#include "ViewPlan.h"

namespace osgWaterReflect
{

/// Writes into each sheet of a plan that is made why what may be done for it is, or is not.
void explain(const ViewFacts& facts, ViewPlan& plan);

} // namespace osgWaterReflect

#endif
