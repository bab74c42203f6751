#include "KeptProgram.h"

#include "../shaders/ShaderSource.h"

using namespace osgWaterReflect;

void KeptProgram::set(osg::StateSet& stateSet, const ProgramKey& key)
{
    const unsigned int generation = ShaderReplacement::generation();
    if (key == _key && generation == _generation) return;
    stateSet.setAttributeAndModes(programOf(key),
                                  osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    setVariant(stateSet, key.images, key.trace, key.output);
    _key = key;
    _generation = generation;
}
