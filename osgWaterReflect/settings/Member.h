#ifndef OSGWATERREFLECT_SETTINGS_MEMBER_H
#define OSGWATERREFLECT_SETTINGS_MEMBER_H

#include <initializer_list>
#include <limits>
#include <type_traits>

namespace osgWaterReflect
{

/// The numbers that a setting may have. They are finite, whatever the bounds.
struct Range
{
    static constexpr double LARGEST = std::numeric_limits<double>::max(); ///< no upper bound

    double lowest;
    double highest;
    bool lowestIncluded; ///< else what is above it

    constexpr bool contains(double value) const // never NaN
    {
        return (value > lowest || (lowestIncluded && value == lowest)) && value <= highest;
    }
};

constexpr Range fromTo(double lowest, double highest)
{
    return {lowest, highest, true};
}
constexpr Range atLeast(double lowest)
{
    return {lowest, Range::LARGEST, true};
}
constexpr Range above(double lowest, double highest = Range::LARGEST)
{
    return {lowest, highest, false};
}

/// A value of an enumeration and its name in C++.
template <typename Enum>
struct Named
{
    const char* name;
    Enum value;
};

/// An enumeration with all its values, in their order.
template <typename Enum>
struct Enumeration
{
    const char* name;
    std::initializer_list<Named<Enum>> values;
};

/// A member of a struct of settings, as users may be shown it. Its default is that of the struct.
template <typename Settings, typename Value>
struct Member
{
    using Choice = std::conditional_t<std::is_enum_v<Value>, Enumeration<Value>, Range>;

    constexpr Member(const char* name, Value Settings::*pointer, const char* unit,
                     const Choice& choice, const char* sentence) :
        name(name),
        pointer(pointer), unit(unit), choice(choice), sentence(sentence)
    {
    }

    const char* name;
    Value Settings::*pointer;
    const char* unit;     ///< "1" for what has none
    Choice choice;        ///< what it may be; of a colour each component
    const char* sentence; ///< what it is
};

} // namespace osgWaterReflect

#endif
