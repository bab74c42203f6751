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

ShaderSlots::Piece piece(const std::string& name, const std::string& text)
{
    return new ShaderPiece(name, text);
}

ShaderSlots withWaves(const ShaderSlots::Piece& waves)
{
    ShaderSlots slots;
    slots.waves = waves;
    return slots;
}

std::string errorOf(const std::string& name, const ShaderSlots& slots = {})
{
    try
    {
        assembleShader(name, slots);
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
    const ShaderSlots slots = withWaves(piece("glass.glsl", "#include \"sand.glsl\"\n"));
    const std::string message = errorOf("water.frag", slots);
    CHECK(message.find("sand.glsl") != std::string::npos);
    CHECK(message.find("glass.glsl") != std::string::npos);
    CHECK(errorOf("fire.frag").find("fire.frag") != std::string::npos);
    const std::string slot =
        errorOf("water.frag", withWaves(piece("glass.glsl", "#include \"sand\"\n")));
    CHECK(slot.find("sand") != std::string::npos);
    CHECK_THROWS_AS(libraryPiece("sand.glsl"), std::runtime_error);
}

// Falls when _open is never asked: the stack then overflows.
TEST_CASE("a shader piece that includes itself is an error that names it")
{
    const std::string message =
        errorOf("water.frag", withWaves(piece("glass.glsl", "#include \"water.frag\"\n")));
    CHECK(message.find("water.frag") != std::string::npos);
    CHECK(message.find("includes itself") != std::string::npos);
}

// Falls when the number behind an included piece is `lineNumber + 1`.
TEST_CASE("every line of an assembled shader is numbered as in its own file")
{
    for (const char* name : {"water.vert", "water.frag", "trace.frag"})
        for (const char* waves : {"waves_calm.glsl", "waves_trochoidal.glsl"})
        {
            const std::vector<std::string> lines =
                linesOf(assembleShader(name, withWaves(libraryPiece(waves))));
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
                    const bool ofEmptySlot = std::regex_match(
                        original[line - 1], std::regex("(#include|#each) \"over\".*"));
                    REQUIRE((ofEmptySlot ? "" : original[line - 1]) == text);
                    seen.insert(pieces[source]);
                }
                ++line;
            }
            CHECK(seen.count(name));
            CHECK(seen.count(waves));
            CHECK(pieces.size() == seen.size());
        }
}

// Falls when textOf() asks the library's pieces first, or a replacement outlives its object.
TEST_CASE("a shader piece is replaced for as long as its replacement lives")
{
    const std::string before = assembleShader("water.frag");
    const unsigned int generation = ShaderReplacement::generation();
    CHECK(ShaderReplacement::all().empty());
    {
        const ShaderReplacement other("fresnel.glsl", "// another law\n");
        const ShaderReplacement waves("glass.glsl", "// new waves\n");
        const std::string assembled =
            assembleShader("water.frag", withWaves(piece("glass.glsl", "// waves of glass\n")));
        CHECK(assembled.find("// another law") != std::string::npos);
        CHECK(assembled.find("// new waves") != std::string::npos);
        CHECK(assembled.find("// waves of glass") == std::string::npos);
        CHECK(assembled.find("float fresnelReflectance") == std::string::npos);
        CHECK(ShaderReplacement::all().find("// another law") != std::string::npos);
        CHECK(ShaderReplacement::generation() == generation + 2);
        CHECK_THROWS_AS(ShaderReplacement("fresnel.glsl", ""), std::runtime_error);
    }
    CHECK(ShaderReplacement::generation() == generation + 4);
    CHECK(assembleShader("water.frag") == before);
    CHECK(ShaderReplacement::all().empty());
}

// Falls when Assembler calls by the piece's own name, or sorts what is in a slot.
TEST_CASE(
    "what is over the water is declared and called in its order, and leaves no line if nothing")
{
    ShaderSlots slots;
    slots.over = {piece("sun_glint.glsl", "// declares sunGlint\n"),
                  piece("fog.glsl", "// declares fog\n")};
    const std::string text = assembleShader("water.frag", slots);
    const std::size_t glint = text.find("// declares sunGlint\n");
    const std::size_t fog = text.find("// declares fog\n");
    const std::size_t calls =
        text.find(" colour = sunGlint(pixel, colour); colour = fog(pixel, colour);\n");
    CHECK(glint < fog);
    CHECK(fog < calls);
    CHECK(calls != std::string::npos);

    const std::string without = assembleShader("water.frag");
    CHECK(without.find("over\"") == std::string::npos);
    CHECK(without.find("over(") == std::string::npos);
}

// Falls with any texture(), texture2D() or textureCube() in a piece.
TEST_CASE("no piece samples with a level of detail that depends on its neighbours")
{
    // Where a search's loops part from pixel to pixel, it is undefined.
    const std::regex implicit("\\btexture(1D|2D|3D|Cube|Proj|2DProj)?\\s*\\(");
    int sampling = 0;
    for (const auto& shader : embeddedShaders)
    {
        const std::string text = assembleShader(shader.first);
        INFO(shader.first);
        CHECK_FALSE(std::regex_search(text, implicit));
        sampling += text.find("textureLod(") != std::string::npos;
    }
    CHECK(sampling > 0);
}

// Falls when interface.glsl calls the columns' stride `side`, as search_hierarchical.glsl does a
// cell's.
TEST_CASE("no short name of the interface renames what a piece calls so itself")
{
    const std::string interface = embeddedShaders.at("interface.glsl");
    const std::regex macro("#define (\\w+) osgwr_\\w+");
    const std::sregex_iterator none;
    int names = 0;
    for (std::sregex_iterator it(interface.begin(), interface.end(), macro); it != none; ++it)
    {
        const std::string name = (*it)[1];
        ++names;
        // A type in front: a local, a parameter, a member or a function of that name.
        const std::regex declared("\\b(void|bool|u?int|float|[biu]?vec[234]|mat[234]|sampler\\w+|"
                                  "[A-Z][a-z]\\w*)\\s+" +
                                  name + "\\b");
        for (const auto& shader : embeddedShaders)
        {
            INFO(name << " in " << shader.first);
            CHECK_FALSE(std::regex_search(shader.second, declared));
        }
    }
    CHECK(names > 20);
}

// Falls when a piece declares a uniform `waveReach`.
TEST_CASE("what a shader shares with the scene it lives in carries the library's prefix")
{
    const std::regex declared("(^|\\n)(uniform|varying|in) +\\w+ +(\\w+)");
    const std::regex imported("#pragma import_defines\\(([^)]*)\\)");
    const std::sregex_iterator none;
    int names = 0;
    for (const auto& shader : embeddedShaders)
    {
        INFO(shader.first);
        const std::string& text = shader.second;
        for (std::sregex_iterator it(text.begin(), text.end(), declared); it != none; ++it)
        {
            CHECK(it->str(3).compare(0, 6, "osgwr_") == 0);
            ++names;
        }
        for (std::sregex_iterator it(text.begin(), text.end(), imported); it != none; ++it)
        {
            std::istringstream list(it->str(1));
            for (std::string name; std::getline(list >> std::ws, name, ',');)
            {
                CHECK(name.compare(0, 6, "OSGWR_") == 0);
                ++names;
            }
        }
    }
    CHECK(names > 25);
}
