#pragma once

#include "Daylight.h"
#include "LakeLand.h"

#include <osg/Group>

namespace waterdata
{

// A group of birches as upright pictures, blended over what is behind them without writing depth.
osg::ref_ptr<osg::Group> treeCards(const LakeLand& land, const Daylight& daylight);

}
