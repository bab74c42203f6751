#ifndef OSGWATERREFLECT_SETTINGS_MEMBERCHECKS_H
#define OSGWATERREFLECT_SETTINGS_MEMBERCHECKS_H

#include "../Check.h"
#include "Members.h"

#include <osg/Vec3>

#include <algorithm>
#include <sstream>
#include <string>

namespace osgWaterReflect
{

/// What a member was expected to be, as the refusal says it, with bounds in the member's type.
template <typename Number>
std::string expectedOf(const Range& range)
{
    const auto lowest = static_cast<Number>(range.lowest);
    std::ostringstream text;
    if (range.highest == Range::LARGEST)
        text << "a finite value " << (range.lowestIncluded ? ">= " : "above ") << lowest;
    else
        text << "a value in " << (range.lowestIncluded ? "[" : "(") << lowest << ", "
             << static_cast<Number>(range.highest) << "]";
    return text.str();
}

template <typename Number>
bool checkValue(const std::string& member, const Range& range, Number value)
{
    return range.contains(value) || refuse(member, expectedOf<Number>(range), value);
}

inline bool checkValue(const std::string& member, const Range& range, const osg::Vec3& colour)
{
    return checkValue(member, range, colour.x()) && checkValue(member, range, colour.y()) &&
           checkValue(member, range, colour.z());
}

template <typename Enum>
bool checkValue(const std::string& member, const Enumeration<Enum>& choice, Enum value)
{
    const bool named = std::any_of(choice.values.begin(), choice.values.end(),
                                   [&](const Named<Enum>& each) { return each.value == value; });
    return named ||
           refuse(member, std::string("a member of ") + choice.name, static_cast<int>(value));
}

/// Whether each member is what its line says it may be; says on OSG_WARN which one is not.
template <typename Settings>
bool checkMembers(const Settings& settings)
{
    bool right = true;
    forEachMember<Settings>(
        [&](const auto& member)
        {
            const std::string name = std::string(MEMBERS<Settings>.structName) + "::" + member.name;
            right = right && checkValue(name, member.choice, settings.*member.pointer);
        });
    return right;
}

template <typename Settings>
bool equalMembers(const Settings& lhs, const Settings& rhs)
{
    bool equal = true;
    forEachMember<Settings>([&](const auto& member)
                            { equal = equal && lhs.*member.pointer == rhs.*member.pointer; });
    return equal;
}

} // namespace osgWaterReflect

#endif
