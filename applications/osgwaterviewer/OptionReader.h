#ifndef OSGWATERVIEWER_OPTIONREADER_H
#define OSGWATERVIEWER_OPTIONREADER_H

#include "Names.h"

#include <osg/ArgumentParser>
#include <osg/Vec3>

#include <charconv>
#include <cmath>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace osgwaterviewer
{

/// Whether a text is a finite number and nothing else.
template <typename Number>
bool parseNumber(const std::string& text, Number& number)
{
    const char* const end = text.data() + text.size();
    Number parsed{};
    const std::from_chars_result result = std::from_chars(text.data(), end, parsed);
    if (result.ec != std::errc() || result.ptr != end) return false;
    if constexpr (std::is_floating_point_v<Number>)
        if (!std::isfinite(parsed)) return false;
    number = parsed;
    return true;
}

/// Whether a text is as many numbers as the vector holds, and separators between them.
template <typename Number>
bool parseNumbers(const std::string& text, char separator, std::vector<Number>& numbers)
{
    std::vector<Number> parsed(numbers.size());
    std::size_t begin = 0;
    for (Number& number : parsed)
    {
        const std::size_t end =
            &number == &parsed.back() ? text.size() : text.find(separator, begin);
        if (end == std::string::npos || begin > text.size()) return false;
        if (!parseNumber(text.substr(begin, end - begin), number)) return false;
        begin = end + 1;
    }
    numbers = parsed;
    return true;
}

/// Takes named options off a command line. Every call also enters its option into the usage, so
/// that what is read and what is listed cannot differ. The first mistake is kept.
class OptionReader
{
public:
    explicit OptionReader(osg::ArgumentParser& arguments) : _arguments(arguments) {}

    /// Whether an option without a value was given.
    bool readFlag(const std::string& name, const std::string& help);

    /// Whether an option was given; its value, unless it is missing. Given twice, the last counts.
    bool read(const std::string& name, const std::string& placeholder, const std::string& help,
              const std::string& defaultText, std::string& value);

    /// The number is the default before and the option's value after.
    template <typename Number>
    bool readNumber(const std::string& name, const std::string& placeholder,
                    const std::string& help, Number& number)
    {
        std::string text;
        if (!read(name, placeholder, help, textOf(number), text)) return false;
        const char* expected =
            std::is_signed_v<Number> ? "a whole number" : "a whole number, not negative";
        if (std::is_floating_point_v<Number>) expected = "a finite number";
        return parseNumber(text, number) || refuse(name, expected, text);
    }

    /// Red, green and blue, with commas between.
    bool readColour(const std::string& name, const std::string& help, osg::Vec3& colour);

    /// The value is the default before and the one that the option names after.
    template <typename Enum>
    bool readName(const std::string& name, const std::string& help,
                  const osgWaterReflect::Enumeration<Enum>& enumeration, Enum& value)
    {
        std::string words;
        for (const auto& each : enumeration.values)
            words += (words.empty() ? "" : "|") + wordOf(each.name);
        std::string text;
        if (!read(name, words, help, wordOf(enumeration, value), text)) return false;
        for (const auto& each : enumeration.values)
            if (text == wordOf(each.name))
            {
                value = each.value;
                return true;
            }
        return refuse(name, "one of " + words, text);
    }

    /// Whether an option that has been read was given.
    bool isGiven(const std::string& name) const { return _given.count(name) > 0; }

    /// Notes a value that cannot be used. Returns false.
    bool refuse(const std::string& name, const std::string& expected, const std::string& got);

    /// What is left of the command line once every option has been read: the files. Anything that
    /// looks like an option is a mistake.
    std::vector<std::string> takeFiles();

    /// Empty where all was well.
    const std::string& getMistake() const { return _mistake; }

    static std::string textOf(double number);

private:
    osg::ArgumentParser& _arguments;
    std::set<std::string> _given; // options
    std::string _mistake;
};

} // namespace osgwaterviewer

#endif
