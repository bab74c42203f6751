#ifndef OSGWATERREFLECT_WATER_VISIBLESHEET_H
#define OSGWATERREFLECT_WATER_VISIBLESHEET_H

#include "../surface/StillWater.h"
#include "../surface/WaveBounds.h"

#include <osgWaterReflect/WaterSurface>

#include <glm/mat4x4.hpp>

#include <memory>

namespace osgWaterReflect
{

class StatusBoard;
class WaterDraw;

/// A sheet of water, as its node hands it to a view.
struct EnrolledSheet
{
    osg::ref_ptr<const WaterSurface> water;
    osg::ref_ptr<const StillWater> sheet;
    unsigned int number = 0;                  ///< of the sheet in the water
    osg::ref_ptr<const WaveState> waves;      ///< in this frame; null for calm water
    std::shared_ptr<const WaveBounds> bounds; ///< of the waves, at all times
    std::shared_ptr<StatusBoard> status;      ///< where the view says what it did
};

/// A sheet of water that a view sees in this frame, as its cull has met it.
struct VisibleSheet : EnrolledSheet
{
    osg::ref_ptr<WaterDraw> draw; ///< what draws it
    glm::dmat4 eyeFromSurface{1.0};
    bool eyeAbove = true; ///< the eye is over the water as it moves
};

} // namespace osgWaterReflect

#endif
