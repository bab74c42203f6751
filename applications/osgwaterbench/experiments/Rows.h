#ifndef OSGWATERBENCH_ROWS_H
#define OSGWATERBENCH_ROWS_H

#include "Measurement.h"
#include "ResultFile.h"
#include "Timing.h"

namespace osgwaterbench
{

/// What is measured, as it stands in result files; null where there is nothing to measure.
/// Names end in their unit.
Json toJson(const Accuracy& accuracy);
Json toJson(const Measures& measures);
Json toJson(const std::optional<TessellationError>& error);
Json toJson(const CaseTime& time);

/// A method's name and settings.
Json toJson(const Method& method);

/// Of all water pixels.
double correctPercent(const Measures& measures);

} // namespace osgwaterbench

#endif
