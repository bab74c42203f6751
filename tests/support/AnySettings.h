#ifndef OSGWATERREFLECT_TESTS_SUPPORT_ANYSETTINGS_H
#define OSGWATERREFLECT_TESTS_SUPPORT_ANYSETTINGS_H

#include "Chance.h"

#include <osgWaterReflect/TrochoidalWaves>
#include <osgWaterReflect/settings/Members.h>

#include <osg/Vec3>

#include <cmath>
#include <type_traits>
#include <vector>

/// Of every size, limits and the numbers next to them, and what is none.
double anyNumber(Chance& chance);

/// Within a range, at one of its bounds in one of eight.
double numberWithin(const osgWaterReflect::Range& range, Chance& chance);

/// At one of a range's bounds or next to it, within it, or any number.
double numberAbout(const osgWaterReflect::Range& range, Chance& chance);

/// What a member may be.
template <typename Value, typename Choice>
Value valueWithin(const Choice& choice, Chance& chance)
{
    if constexpr (std::is_enum_v<Value>)
        return chance.oneOf(choice.values).value;
    else if constexpr (std::is_integral_v<Value>)
        return static_cast<Value>(std::llround(numberWithin(choice, chance)));
    else if constexpr (std::is_same_v<Value, osg::Vec3>)
        return osg::Vec3(numberWithin(choice, chance), numberWithin(choice, chance),
                         numberWithin(choice, chance));
    else
        return numberWithin(choice, chance);
}

/// What a member may be, or may not.
template <typename Value, typename Choice>
Value anyValue(const Choice& choice, Chance& chance)
{
    auto value = valueWithin<Value>(choice, chance);
    if constexpr (std::is_enum_v<Value>)
    {
        if (chance.once(8)) value = static_cast<Value>(chance.oneOf({-1, 0, 99}));
    }
    else if constexpr (std::is_integral_v<Value>)
    {
        if (chance.once(2))
            value = static_cast<Value>(std::llround(chance.oneOf({choice.lowest, choice.highest}) +
                                                    chance.integer(-1, 1)));
    }
    else if constexpr (std::is_same_v<Value, osg::Vec3>)
        value[chance.integer(0, 2)] = static_cast<float>(numberAbout(choice, chance));
    else
        value = numberAbout(choice, chance);
    return value;
}

/// Settings within their ranges, half of the members off their defaults.
template <typename Settings>
Settings goodSettings(Chance& chance)
{
    Settings settings;
    osgWaterReflect::forEachMember<Settings>(
        [&](const auto& member)
        {
            auto& value = settings.*member.pointer;
            if (chance.once(2))
                value = valueWithin<std::decay_t<decltype(value)>>(member.choice, chance);
        });
    return settings;
}

/// Such settings, but for some members of any value: about half are out of range.
template <typename Settings>
Settings anySettings(Chance& chance)
{
    Settings settings = goodSettings<Settings>(chance);
    osgWaterReflect::forEachMember<Settings>(
        [&](const auto& member)
        {
            auto& value = settings.*member.pointer;
            if (chance.once(2))
                value = anyValue<std::decay_t<decltype(value)>>(member.choice, chance);
        });
    return settings;
}

/// None to four waves.
std::vector<osgWaterReflect::TrochoidalWave> anyWaves(Chance& chance);

#endif
