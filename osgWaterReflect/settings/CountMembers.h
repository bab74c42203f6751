#ifndef OSGWATERREFLECT_SETTINGS_COUNTMEMBERS_H
#define OSGWATERREFLECT_SETTINGS_COUNTMEMBERS_H

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace osgWaterReflect
{

/// Stands for a value of any type, where the compiler is asked what a struct can be made of.
struct AnyValue
{
    template <typename Value>
    operator Value() const;
};

template <typename Struct, typename Values, typename = void>
struct CanBeMadeOf : std::false_type
{
};

template <typename Struct, typename... Values>
struct CanBeMadeOf<Struct, std::tuple<Values...>, std::void_t<decltype(Struct{Values()...})>>
    : std::true_type
{
};

/// Number of members of a struct without constructors or bases, none of them an array or such a
/// struct itself: the most values that it can be made of in braces.
template <typename Struct, typename... Values>
constexpr std::size_t countMembers()
{
    if constexpr (CanBeMadeOf<Struct, std::tuple<Values..., AnyValue>>::value)
        return countMembers<Struct, Values..., AnyValue>();
    else
        return sizeof...(Values);
}

} // namespace osgWaterReflect

#endif
