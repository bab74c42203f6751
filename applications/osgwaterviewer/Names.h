#ifndef OSGWATERVIEWER_NAMES_H
#define OSGWATERVIEWER_NAMES_H

#include <osgWaterReflect/WaterSurface>

#include <cstddef>

namespace osgwaterviewer
{

/// A word of the command line, of the help and of the reports for a member of an enumeration.
template <typename Value>
struct Named
{
    const char* name;
    Value value;
};

constexpr Named<osgWaterReflect::Search> SEARCHES[] = {
    {"sequential", osgWaterReflect::Search::SEQUENTIAL},
    {"binary", osgWaterReflect::Search::BINARY},
    {"hierarchical", osgWaterReflect::Search::HIERARCHICAL},
    {"automatic", osgWaterReflect::Search::AUTOMATIC}};

constexpr Named<osgWaterReflect::CaptureKind> CAPTURES[] = {
    {"view", osgWaterReflect::CaptureKind::VIEW},
    {"frame", osgWaterReflect::CaptureKind::FRAME},
    {"mirror", osgWaterReflect::CaptureKind::MIRROR},
    {"view-and-mirror", osgWaterReflect::CaptureKind::VIEW_AND_MIRROR},
    {"automatic", osgWaterReflect::CaptureKind::AUTOMATIC}};

constexpr Named<osgWaterReflect::GuardBandKind> GUARD_BANDS[] = {
    {"none", osgWaterReflect::GuardBandKind::NONE},
    {"adaptive", osgWaterReflect::GuardBandKind::ADAPTIVE},
    {"fixed", osgWaterReflect::GuardBandKind::FIXED}};

constexpr Named<osgWaterReflect::WaterSurface::DebugView> DEBUG_VIEWS[] = {
    {"none", osgWaterReflect::WaterSurface::DebugView::NONE},
    {"reason", osgWaterReflect::WaterSurface::DebugView::REASON},
    {"reflection", osgWaterReflect::WaterSurface::DebugView::REFLECTION}};

/// The entry of a value, which the table has.
template <typename Value, std::size_t Count>
const Named<Value>& entryOf(const Named<Value> (&table)[Count], Value value)
{
    std::size_t i = 0;
    while (i + 1 < Count && table[i].value != value)
        ++i;
    return table[i];
}

/// The entry after a value's own, the first one after the last.
template <typename Value, std::size_t Count>
const Named<Value>& entryAfter(const Named<Value> (&table)[Count], Value value)
{
    return table[(&entryOf(table, value) - table + 1) % Count];
}

} // namespace osgwaterviewer

#endif
