#include "Names.h"

#include <cctype>

using namespace osgwaterviewer;

std::string osgwaterviewer::wordOf(const std::string& enumerator)
{
    std::string word;
    for (const unsigned char letter : enumerator)
        word += letter == '_' ? '-' : static_cast<char>(std::tolower(letter));
    return word;
}

std::string osgwaterviewer::optionOf(const std::string& member)
{
    if (member == "frameTimeTarget") return "--frame-time"; // its help says what it is
    std::string option = "--";
    for (const unsigned char letter : member)
    {
        if (std::isupper(letter)) option += '-';
        option += static_cast<char>(std::tolower(letter));
    }
    return option;
}
