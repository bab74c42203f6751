#ifndef OSGWATERREFLECT_SETTINGS_MEMBERS_H
#define OSGWATERREFLECT_SETTINGS_MEMBERS_H

#include "CountMembers.h"
#include "Member.h"

#include <osgWaterReflect/ReflectionSettings>
#include <osgWaterReflect/SurfaceDetail>
#include <osgWaterReflect/ViewSettings>
#include <osgWaterReflect/WaterOptics>

#include <tuple>

/// \file
/// The one table of all settings of a water. They are checked and compared by it, the tests draw
/// random ones by it, and the viewer has an option for each of its lines.

namespace osgWaterReflect
{

inline constexpr Enumeration<Search> SEARCHES = {"Search",
                                                 {{"SEQUENTIAL", Search::SEQUENTIAL},
                                                  {"BINARY", Search::BINARY},
                                                  {"HIERARCHICAL", Search::HIERARCHICAL},
                                                  {"AUTOMATIC", Search::AUTOMATIC}}};

inline constexpr Enumeration<CaptureKind> CAPTURE_KINDS = {
    "CaptureKind",
    {{"VIEW", CaptureKind::VIEW},
     {"FRAME", CaptureKind::FRAME},
     {"MIRROR", CaptureKind::MIRROR},
     {"VIEW_AND_MIRROR", CaptureKind::VIEW_AND_MIRROR},
     {"AUTOMATIC", CaptureKind::AUTOMATIC}}};

inline constexpr Enumeration<GuardBandKind> GUARD_BAND_KINDS = {
    "GuardBandKind",
    {{"NONE", GuardBandKind::NONE},
     {"ADAPTIVE", GuardBandKind::ADAPTIVE},
     {"FIXED", GuardBandKind::FIXED}}};

/// The members of one struct, in the order in which they are checked and listed.
template <typename... Members>
struct MemberTable
{
    constexpr MemberTable(const char* structName, const Members&... members) :
        structName(structName), members(members...)
    {
    }

    const char* structName;
    std::tuple<Members...> members;
};

/// The table of a struct: MEMBERS<ReflectionSettings>, for one. A line says
///     name, member, unit, what it may be, what it is.
template <typename Settings>
inline constexpr void* MEMBERS = nullptr;

template <>
inline constexpr auto MEMBERS<ReflectionSettings> =
    MemberTable("ReflectionSettings",
                Member("search", &ReflectionSettings::search, "1", SEARCHES,
                       "How reflected rays are looked for in the captured image."),
                Member("capture", &ReflectionSettings::capture, "1", CAPTURE_KINDS,
                       "The image that reflected rays are looked for in."),
                Member("thickness", &ReflectionSettings::thickness, "world units", above(0.0),
                       "How far behind a visible surface still counts as inside it."),
                Member("stride", &ReflectionSettings::stride, "pixels", fromTo(1, 64),
                       "A sequential search looks at every stride-th column."));

template <>
inline constexpr auto MEMBERS<ViewSettings> =
    MemberTable("ViewSettings",
                Member("captureScale", &ViewSettings::captureScale, "1", above(0.0, 1.0),
                       "Size of the captured image over the view's."),
                Member("traceScale", &ViewSettings::traceScale, "1", above(0.0, 1.0),
                       "Size of the image that rays are searched for in first over the view's."),
                Member("guardBand", &ViewSettings::guardBand, "1", GUARD_BAND_KINDS,
                       "How far the captured image reaches beyond the view's borders."),
                Member("maxExtraPixels", &ViewSettings::maxExtraPixels, "1", fromTo(0.0, 3.0),
                       "Ceiling of an adaptive guard band: its pixels over the view's."),
                Member("guardBandShare", &ViewSettings::guardBandShare, "1", fromTo(0.0, 1.0),
                       "Each side of a fixed guard band over the view's width or height."),
                Member("frameTimeTarget", &ViewSettings::frameTimeTarget, "ms", atLeast(0.0),
                       "Accuracy is given up step by step where frames take longer; 0: never."));

template <>
inline constexpr auto MEMBERS<WaterOptics> = MemberTable(
    "WaterOptics",
    Member("refractiveIndex", &WaterOptics::refractiveIndex, "1", fromTo(1.0, 4.0),
           "Refractive index of the water over that of the air."),
    Member("waterColour", &WaterOptics::waterColour, "1", fromTo(0.0, 1.0),
           "What the water sends back where it does not reflect: red, green and blue."));

template <>
inline constexpr auto MEMBERS<SurfaceDetail> = MemberTable(
    "SurfaceDetail",
    Member("maxEdgePixels", &SurfaceDetail::maxEdgePixels, "pixels", fromTo(1.0, 1024.0),
           "Longest edge of the mesh of moving water, where the waves stray from it."),
    Member("maxErrorPixels", &SurfaceDetail::maxErrorPixels, "pixels", above(0.0, 64.0),
           "How far moving water may stray from edges of its mesh that are longer."),
    Member("maxVertices", &SurfaceDetail::maxVertices, "1", fromTo(1000, 10000000),
           "Most vertices of the mesh of moving water."));

/// Calls a visitor with each line of a struct's table. A member without a line does not compile.
template <typename Settings, typename Visitor>
void forEachMember(Visitor&& visitor)
{
    constexpr const auto& lines = MEMBERS<Settings>.members;
    static_assert(std::tuple_size_v<std::decay_t<decltype(lines)>> == countMembers<Settings>(),
                  "Members.h: expected a line for each member of these settings");
    std::apply([&](const auto&... members) { (visitor(members), ...); }, lines);
}

} // namespace osgWaterReflect

#endif
