#ifndef OSGWATERREFLECT_CHECK_H
#define OSGWATERREFLECT_CHECK_H

#include <osg/Notify>

#include <string>

namespace osgWaterReflect
{

/// Says that a value was refused, in the form that all of this library's refusals have:
/// "Class::member: expected ..., got ...". Returns false, for the caller to hand on.
template <typename Value>
bool refuse(const std::string& member, const std::string& expected, const Value& got)
{
    OSG_WARN << member << ": expected " << expected << ", got " << got << std::endl;
    return false;
}

/// Whether value lies in [lowest, highest]; says what was refused where it does not. NaN never
/// does.
template <typename Number>
bool expectRange(const char* member, Number value, Number lowest, Number highest)
{
    if (value >= lowest && value <= highest) return true;
    OSG_WARN << member << ": expected a value in [" << lowest << ", " << highest << "], got "
             << value << std::endl;
    return false;
}

} // namespace osgWaterReflect

#endif
