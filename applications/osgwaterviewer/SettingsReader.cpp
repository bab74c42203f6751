#include "SettingsReader.h"

using namespace osgwaterviewer;
using osgWaterReflect::Range;

std::string osgwaterviewer::helpOf(const std::string& unit, const Range& range)
{
    std::string text = unit == "1" ? "" : unit + ", ";
    text += (range.lowestIncluded ? "" : "above ") + OptionReader::textOf(range.lowest);
    if (range.highest < Range::LARGEST)
        text += (range.lowestIncluded ? " to " : ", up to ") + OptionReader::textOf(range.highest);
    else if (range.lowestIncluded)
        text += " or more";
    return " (" + text + ")";
}
