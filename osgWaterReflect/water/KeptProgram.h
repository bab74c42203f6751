#ifndef OSGWATERREFLECT_WATER_KEPTPROGRAM_H
#define OSGWATERREFLECT_WATER_KEPTPROGRAM_H

#include "WaterProgram.h"

#include <optional>

namespace osgWaterReflect
{

/// The program in a StateSet, looked up again only where its key is another than in the frame
/// before.
class KeptProgram
{
public:
    /// Has the state set hold the program of the key and choose its variant.
    void set(osg::StateSet& stateSet, const ProgramKey& key);

private:
    std::optional<ProgramKey> _key; // none until the first
    unsigned int _generation = 0;   // of shader replacements, when it was looked up
};

} // namespace osgWaterReflect

#endif
