#ifndef OSGWATERVIEWER_NAMES_H
#define OSGWATERVIEWER_NAMES_H

#include <osgWaterReflect/WaterSurface>
#include <osgWaterReflect/settings/Member.h>

#include <algorithm>
#include <string>

namespace osgwaterviewer
{

/// The debug views that tell something in a picture of 8 bits.
inline constexpr osgWaterReflect::Enumeration<osgWaterReflect::WaterSurface::DebugView>
    DEBUG_VIEWS = {"DebugView",
                   {{"NONE", osgWaterReflect::WaterSurface::DebugView::NONE},
                    {"REASON", osgWaterReflect::WaterSurface::DebugView::REASON},
                    {"REFLECTION", osgWaterReflect::WaterSurface::DebugView::REFLECTION}}};

/// How the command line, the help and the reports write what is VIEW_AND_MIRROR in C++:
/// view-and-mirror.
std::string wordOf(const std::string& enumerator);

/// How the command line names the option of a member: --capture-scale for captureScale.
std::string optionOf(const std::string& member);

/// The word for a value that the enumeration has.
template <typename Enum>
std::string wordOf(const osgWaterReflect::Enumeration<Enum>& enumeration, Enum value)
{
    for (const osgWaterReflect::Named<Enum>& each : enumeration.values)
        if (each.value == value) return wordOf(each.name);
    return "";
}

/// The value after another; the first one after the last, and after one that is not listed.
template <typename Enum>
Enum valueAfter(const osgWaterReflect::Enumeration<Enum>& enumeration, Enum value)
{
    const auto* const end = enumeration.values.end();
    const auto* const found =
        std::find_if(enumeration.values.begin(), end,
                     [&](const osgWaterReflect::Named<Enum>& each) { return each.value == value; });
    const bool hasNext = found != end && found + 1 != end;
    return (hasNext ? found + 1 : enumeration.values.begin())->value;
}

} // namespace osgwaterviewer

#endif
