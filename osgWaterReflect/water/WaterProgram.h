#ifndef OSGWATERREFLECT_WATER_WATERPROGRAM_H
#define OSGWATERREFLECT_WATER_WATERPROGRAM_H

#include "../effects/EffectList.h"
#include "../shaders/ShaderSlots.h"
#include "WaterSettings.h"

#include <osgWaterReflect/WaterSurface>

#include <osg/Program>
#include <osg/StateSet>

namespace osgWaterReflect
{

/// How many captures a ray is looked for in: the values of OSGWR_IMAGES.
enum class Images
{
    ONE = 1,
    TWO ///< the eye's and, for what that hides or loses, the mirrored eye's
};

/// Where rays are searched for: the values of OSGWR_TRACE.
enum class Trace
{
    HERE = 1, ///< by each pixel
    SAMPLED   ///< by those of a smaller image first
};

/// What a program is for.
enum class WaterPass
{
    SHADE, ///< the water as the view shows it
    TRACE  ///< its rays, traced for the smaller image of Trace::SAMPLED
};

/// All that decides what program draws water. Drawing and compiling ahead make it by the same
/// functions.
struct ProgramKey
{
    WaterPass pass = WaterPass::SHADE;
    ShaderSlots slots;
    Images images = Images::ONE;
    Trace trace = Trace::HERE;
    WaterSurface::DebugView output = WaterSurface::DebugView::NONE;

    bool operator==(const ProgramKey& rhs) const
    {
        return pass == rhs.pass && slots == rhs.slots && images == rhs.images &&
               trace == rhs.trace && output == rhs.output;
    }
};

/// The key of water with these settings.
///   effects  that are seen of it (effectsOf)
ProgramKey keyOf(WaterPass pass, const WaterSurface& water, const WaterSettings& settings,
                 Images images, const std::vector<const Effect*>& effects);

/// The piece of a search; of AUTOMATIC that of HIERARCHICAL.
ShaderSlots::Piece searchPiece(Search search);

/// The program of a key; of several variants that differ in images, trace and output. It exists as
/// long as somebody holds it.
osg::ref_ptr<osg::Program> programOf(const ProgramKey& key);

/// Chooses a variant of a program.
void setVariant(osg::StateSet& stateSet, Images images, Trace trace,
                WaterSurface::DebugView output);

} // namespace osgWaterReflect

#endif
