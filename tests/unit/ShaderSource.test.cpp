#include "support/Catch.h"

#include <osgWaterReflect/shaders/ShaderSource.h>

#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <sstream>

using namespace osgWaterReflect;

namespace
{

std::string errorOf(const std::string& name, const std::string& waves)
{
    try
    {
        assembleShader(name, waves);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "";
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

// Falls when include() leaves out the includer, or takes a missing piece for an empty one.
TEST_CASE("a missing shader piece is an error that names it and its includer")
{
    const std::string message = errorOf("water.frag", "waves_of_glass.glsl");
    CHECK(message.find("waves_of_glass.glsl") != std::string::npos);
    CHECK(message.find("water.frag") != std::string::npos);
    const std::string top = errorOf("fire.frag", "waves_calm.glsl");
    CHECK(top.find("fire.frag") != std::string::npos);
}

// Falls when _open is never asked: the stack then overflows.
TEST_CASE("a shader piece that includes itself is an error that names it")
{
    const std::string message = errorOf("water.frag", "water.frag");
    CHECK(message.find("water.frag") != std::string::npos);
    CHECK(message.find("includes itself") != std::string::npos);
}

// Falls when the number behind an included piece is `lineNumber + 1`.
TEST_CASE("every line of an assembled shader is numbered as in its own file")
{
    for (const char* name : {"water.vert", "water.frag"})
        for (const char* waves : {"waves_calm.glsl", "waves_trochoidal.glsl"})
        {
            const std::vector<std::string> lines = linesOf(assembleShader(name, waves));
            REQUIRE(lines.front() == "#version 130");

            // As a compiler of GLSL 1.30 counts: the line after `#line N S` is number N + 1 of
            // source string S (its specification, 3.3); 3.30 changed that to N.
            std::map<int, std::string> pieces;
            std::set<std::string> seen;
            int line = 1;
            int source = 0;
            for (const std::string& text : lines)
            {
                int number = 0;
                char piece[100];
                if (std::sscanf(text.c_str(), "// source string %d: %99s", &number, piece) == 2)
                {
                    pieces[number] = piece;
                    continue; // in front of the first #line
                }
                if (std::sscanf(text.c_str(), "#line %d %d", &line, &source) == 2)
                {
                    ++line;
                    continue;
                }
                if (line > 1 || source > 0)
                {
                    REQUIRE(pieces.count(source));
                    const std::vector<std::string> original =
                        linesOf(embeddedShaders.at(pieces[source]));
                    INFO(pieces[source] << ":" << line << ": " << text);
                    REQUIRE(line >= 1);
                    REQUIRE(line <= static_cast<int>(original.size()));
                    REQUIRE(original[line - 1] == text);
                    seen.insert(pieces[source]);
                }
                ++line;
            }
            CHECK(seen.count(name));
            CHECK(seen.count(waves));
            CHECK(pieces.size() == seen.size());
        }
}

// Falls when findPiece() asks the library's pieces first, or a replacement outlives its object.
TEST_CASE("a shader piece is replaced for as long as its replacement lives")
{
    const std::string before = assembleShader("water.frag", "waves_calm.glsl");
    CHECK(ShaderReplacement::all().empty());
    {
        const ShaderReplacement other("fresnel.glsl", "// another law\n");
        const ShaderReplacement waves("waves_of_glass.glsl", "// new waves\n");
        const std::string assembled = assembleShader("water.frag", "waves_of_glass.glsl");
        CHECK(assembled.find("// another law") != std::string::npos);
        CHECK(assembled.find("// new waves") != std::string::npos);
        CHECK(assembled.find("float fresnelReflectance") == std::string::npos);
        CHECK(ShaderReplacement::all().find("// another law") != std::string::npos);
        CHECK_THROWS_AS(ShaderReplacement("fresnel.glsl", ""), std::runtime_error);
    }
    CHECK(assembleShader("water.frag", "waves_calm.glsl") == before);
    CHECK(ShaderReplacement::all().empty());
}

// Falls with any texture(), texture2D() or textureCube() in a piece.
TEST_CASE("no piece samples with a level of detail that depends on its neighbours")
{
    // Where a search's loops part from pixel to pixel, it is undefined.
    const std::regex implicit("\\btexture(1D|2D|3D|Cube|Proj|2DProj)?\\s*\\(");
    int sampling = 0;
    for (const auto& piece : embeddedShaders)
    {
        const std::string text = assembleShader(piece.first, "waves_calm.glsl");
        INFO(piece.first);
        CHECK_FALSE(std::regex_search(text, implicit));
        sampling += text.find("textureLod(") != std::string::npos;
    }
    CHECK(sampling > 0);
}
