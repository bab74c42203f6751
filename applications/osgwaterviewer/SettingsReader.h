#ifndef OSGWATERVIEWER_SETTINGSREADER_H
#define OSGWATERVIEWER_SETTINGSREADER_H

#include "Names.h"
#include "OptionReader.h"

#include <osgWaterReflect/settings/Members.h>

namespace osgwaterviewer
{

/// What a number may be, for the help: " (world units, above 0)".
std::string helpOf(const std::string& unit, const osgWaterReflect::Range& range);

/// Reads one option for each member of some settings, listed with what the library's table says of
/// it. Values out of range are left for the settings' own check.
template <typename Settings>
void readSettings(OptionReader& reader, Settings& settings)
{
    osgWaterReflect::forEachMember<Settings>(
        [&](const auto& member)
        {
            auto& value = settings.*member.pointer;
            const std::string option = optionOf(member.name);
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_enum_v<Value>)
                reader.readName(option, member.sentence, member.choice, value);
            else
            {
                const std::string help = member.sentence + helpOf(member.unit, member.choice);
                if constexpr (std::is_same_v<Value, osg::Vec3>)
                    reader.readColour(option, help, value);
                else
                    reader.readNumber(option, std::is_integral_v<Value> ? "COUNT" : "NUMBER", help,
                                      value);
            }
        });
}

} // namespace osgwaterviewer

#endif
