// The version stands in the headers, for applications, and in CMakeLists.txt, for packages.

#include "support/Catch.h"

#include <osgWaterReflect/Version>

#include <fstream>
#include <sstream>
#include <string>

// Breaks where one of the two is raised and not the other.
TEST_CASE("the headers' version is the project's")
{
    std::ifstream file(std::string(OSGWATERREFLECT_TEST_DIRECTORY) + "/../CMakeLists.txt");
    std::stringstream text;
    text << file.rdbuf();
    const std::string project =
        "project(osgWaterReflect VERSION " + std::string(osgWaterReflectGetVersion()) + " ";
    CHECK(text.str().find(project) != std::string::npos);
    std::ostringstream numbers;
    numbers << OSGWATERREFLECT_MAJOR_VERSION << '.' << OSGWATERREFLECT_MINOR_VERSION << '.'
            << OSGWATERREFLECT_PATCH_VERSION;
    CHECK(numbers.str() == osgWaterReflectGetVersion());
    CHECK(osgWaterReflectGetLibraryName() == std::string("osgWaterReflect Library"));
}
