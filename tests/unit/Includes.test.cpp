// The library's folders stand in a line: what is in one knows nothing of those after it.

#include "support/Catch.h"

#include <osgDB/FileUtils>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace
{

const std::string LIBRARY = std::string(OSGWATERREFLECT_TEST_DIRECTORY) + "/../osgWaterReflect/";

// In the order in which data goes through them; docs/conventions.md says why.
const std::vector<std::string> FOLDERS = {"settings", "shaders", "passes", "waves",
                                          "dynamics", "surface", "band",   "capture",
                                          "images",   "effects", "water",  "view"};

int placeOf(const std::string& folder)
{
    return static_cast<int>(std::find(FOLDERS.begin(), FOLDERS.end(), folder) - FOLDERS.begin());
}

struct Include
{
    std::string file;   // below the library's folder
    std::string folder; // that it includes from; empty: the library's own
};

// Private files that a file of a folder includes, with the folders that they are in.
void collect(const std::string& folder, std::vector<Include>& includes)
{
    for (const std::string& name : osgDB::getDirectoryContents(LIBRARY + folder))
    {
        if (name[0] == '.') continue;
        const std::string file = folder + "/" + name;
        if (osgDB::fileType(LIBRARY + file) == osgDB::DIRECTORY)
        {
            collect(file, includes);
            continue;
        }
        std::ifstream text(LIBRARY + file);
        const std::string directive = "#include \"";
        for (std::string line; std::getline(text, line);)
        {
            if (line.compare(0, directive.size(), directive) != 0) continue;
            std::string path = line.substr(directive.size(), line.rfind('"') - directive.size());
            std::string from = folder;
            for (; path.compare(0, 3, "../") == 0; path.erase(0, 3))
                from = from.find('/') == std::string::npos ? "" : from.substr(0, from.rfind('/'));
            const std::string whole = from.empty() ? path : from + "/" + path;
            const std::size_t slash = whole.find('/');
            includes.push_back({file, slash == std::string::npos ? "" : whole.substr(0, slash)});
        }
    }
}

} // namespace

// Breaks with an #include "../view/ViewPlan.h" in any other folder.
TEST_CASE("a folder includes only those before it")
{
    int numIncludes = 0;
    for (const std::string& folder : FOLDERS)
    {
        std::vector<Include> includes;
        if (osgDB::fileExists(LIBRARY + folder)) collect(folder, includes);
        for (const Include& include : includes)
        {
            if (include.folder.empty()) continue; // what all may use: Check.h, Transforms.h
            ++numIncludes;
            INFO(include.file << " includes a file of " << include.folder);
            CHECK(placeOf(include.folder) <= placeOf(folder));
        }
    }
    CHECK(numIncludes > 50);
}

// Breaks where a folder is added and not given its place.
TEST_CASE("every folder of the library has its place in the line")
{
    const std::vector<std::string> apart = {"offscreen", "reference"}; // not part of the library
    for (const std::string& name : osgDB::getDirectoryContents(LIBRARY))
    {
        if (name[0] == '.' || osgDB::fileType(LIBRARY + name) != osgDB::DIRECTORY) continue;
        if (std::find(apart.begin(), apart.end(), name) != apart.end()) continue;
        INFO(name);
        CHECK(placeOf(name) < static_cast<int>(FOLDERS.size()));
    }
}
