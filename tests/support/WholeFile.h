#ifndef OSGWATERREFLECT_TESTS_SUPPORT_WHOLEFILE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_WHOLEFILE_H

#include "Catch.h"

#include <fstream>
#include <sstream>
#include <string>

/// The text of a file of the source tree, by its path there.
inline std::string wholeFile(const std::string& path)
{
    std::ifstream file(std::string(OSGWATERREFLECT_TEST_DIRECTORY) + "/../" + path);
    std::stringstream text;
    text << file.rdbuf();
    REQUIRE(!text.str().empty());
    return text.str();
}

#endif
