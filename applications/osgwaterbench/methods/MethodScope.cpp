#include "MethodScope.h"

#include <osgWaterReflect/water/WaterProgram.h>

#include <stdexcept>

using namespace osgwaterbench;

MethodScope::MethodScope(const Method& method, TestBed& bed) : _bed(bed)
{
    if (method.mirror && !bed.mirror)
        throw std::runtime_error("MethodScope: expected a mirrored camera for the method " +
                                 method.name + ", got none");

    for (const auto& piece : method.pieces)
        _replacements.emplace_back(piece.first, piece.second);
    using osgWaterReflect::WaterPass;
    const auto hold = [&](WaterPass pass)
    {
        bed.programs.insert(programOf(
            keyOf(pass, *bed.water, method.settings, osgWaterReflect::Images::ONE,
                  osgWaterReflect::effectsOf(*bed.water, osgWaterReflect::EffectView()))));
    };
    hold(WaterPass::SHADE);
    if (method.settings.traceScale < 1.0) hold(WaterPass::TRACE);
    bed.water->setReflection(method.settings);
    bed.water->setViewSettings(method.settings);

    if (bed.mirror) bed.mirror->setNodeMask(method.mirror ? ~0u : 0u);
    if (method.mirror) bed.mirror->showOn(*bed.water->getOrCreateStateSet(), *method.mirror);
    if (!method.usesCapture)
    {
        _notCaptured = new NotCaptured;
        bed.scene->addCullCallback(_notCaptured);
    }
}

MethodScope::~MethodScope()
{
    if (_notCaptured) _bed.scene->removeCullCallback(_notCaptured);
    if (_bed.mirror) _bed.mirror->setNodeMask(0u);
}
