#include "OptionReader.h"

#include <osg/ApplicationUsage>

#include <sstream>

using namespace osgwaterviewer;

bool OptionReader::readFlag(const std::string& name, const std::string& help)
{
    _arguments.getApplicationUsage()->addCommandLineOption(name, help);
    bool given = false;
    while (_arguments.read(name))
        given = true;
    return given;
}

bool OptionReader::read(const std::string& name, const std::string& placeholder,
                        const std::string& help, const std::string& defaultText, std::string& value)
{
    _arguments.getApplicationUsage()->addCommandLineOption(name + " " + placeholder,
                                                           help + " [" + defaultText + "]");
    for (int position = _arguments.find(name); position > 0; position = _arguments.find(name))
    {
        const bool hasValue = position + 1 < _arguments.argc() &&
                              std::string(_arguments[position + 1]).compare(0, 2, "--") != 0;
        if (!hasValue)
        {
            _arguments.remove(position);
            return refuse(name, placeholder, "nothing");
        }
        value = _arguments[position + 1];
        _arguments.remove(position, 2);
        _given.insert(name);
    }
    return isGiven(name);
}

bool OptionReader::refuse(const std::string& name, const std::string& expected,
                          const std::string& got)
{
    if (_mistake.empty()) _mistake = name + ": expected " + expected + ", got " + got;
    return false;
}

std::vector<std::string> OptionReader::takeFiles()
{
    // Mistakes in the options that osgViewer has read itself.
    if (_mistake.empty() && !_arguments.getErrorMessageMap().empty())
        _mistake = _arguments.getErrorMessageMap().begin()->first;

    std::vector<std::string> files;
    for (int position = 1; position < _arguments.argc(); ++position)
        if (_arguments.isOption(position))
            refuse(_arguments[position], "an option that --help lists", "an unknown one");
        else
            files.push_back(_arguments[position]);
    return files;
}

bool OptionReader::readColour(const std::string& name, const std::string& help, osg::Vec3& colour)
{
    std::string text;
    if (!read(name, "r,g,b", help,
              textOf(colour.x()) + "," + textOf(colour.y()) + "," + textOf(colour.z()), text))
        return false;
    std::vector<float> rgb(3);
    if (!parseNumbers(text, ',', rgb))
        return refuse(name, "three finite numbers with commas between", text);
    colour.set(rgb[0], rgb[1], rgb[2]);
    return true;
}

std::string OptionReader::textOf(double number)
{
    if (std::abs(number) < 1e9 && number == std::floor(number))
        return std::to_string(static_cast<int>(number));
    std::ostringstream text;
    text << number;
    return text.str();
}
