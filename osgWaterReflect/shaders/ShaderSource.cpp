#include "ShaderSource.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <mutex>
#include <sstream>
#include <utility>

using namespace osgWaterReflect;

namespace
{

std::mutex replacementsMutex;
std::map<std::string, std::string> replacements;
std::atomic<unsigned int> replacementsGeneration{0};

// What is between the quotes of a line `#directive "name" …`; empty where it is no such line.
std::string nameIn(const std::string& line, const std::string& directive)
{
    const std::string start = directive + " \"";
    if (line.compare(0, start.size(), start) != 0) return "";
    return line.substr(start.size(), line.find('"', start.size()) - start.size());
}

// sunGlint of sun_glint.glsl.
std::string functionOf(const ShaderPiece& piece)
{
    std::string function;
    bool capital = false;
    for (const char c : piece.getName().substr(0, piece.getName().find('.')))
    {
        if (c != '_') function += capital ? static_cast<char>(std::toupper(c)) : c;
        capital = c == '_';
    }
    return function;
}

class Assembler
{
public:
    explicit Assembler(const ShaderSlots& slots) : _slots(slots) {}

    std::string run(const std::string& name)
    {
        std::ostringstream body;
        include(name, nullptr, "the program", body);

        // #version has to stay first; what the numbers mean comes right after it.
        std::string text = body.str();
        std::ostringstream legend;
        for (std::size_t i = 0; i < _pieces.size(); ++i)
            legend << "// source string " << i << ": " << _pieces[i] << "\n";
        legend << "#line 1 0\n";
        return text.insert(text.find('\n') + 1, legend.str());
    }

private:
    // Replaced, or given, or a file.
    static std::string textOf(const std::string& name, const ShaderPiece* given,
                              const std::string& includer)
    {
        {
            const std::lock_guard<std::mutex> lock(replacementsMutex);
            const auto found = replacements.find(name);
            if (found != replacements.end()) return found->second;
        }
        if (given) return given->getText();
        const auto found = embeddedShaders.find(name);
        if (found != embeddedShaders.end()) return found->second;
        throw std::runtime_error("shader piece " + name + ", included by " + includer +
                                 ": expected a file of shaders/, got none");
    }

    // Until GLSL 3.30 the line after "#line N" counts as N + 1 (its specification, 3.3).
    void include(const std::string& piece, const ShaderPiece* given, const std::string& includer,
                 std::ostringstream& out)
    {
        const std::string text = textOf(piece, given, includer);
        if (std::find(_open.begin(), _open.end(), piece) != _open.end())
            throw std::runtime_error("shader piece " + piece + " includes itself");

        const std::size_t number = _pieces.size();
        _pieces.push_back(piece);
        _open.push_back(piece);
        std::istringstream lines(text);
        std::string line;
        for (int lineNumber = 1; std::getline(lines, line); ++lineNumber)
        {
            const std::string included = nameIn(line, "#include");
            const std::string called = nameIn(line, "#each");
            const bool isFile = included.find('.') != std::string::npos;
            const std::size_t before = _pieces.size();
            if (isFile)
                includeNext(included, nullptr, piece, out);
            else if (!included.empty())
                for (const ShaderSlots::Piece& inSlot : _slots.in(included))
                    includeNext(inSlot->getName(), inSlot, piece, out);
            if (_pieces.size() > before)
                out << "#line " << lineNumber << " " << number << "\n";
            else
                out << (!included.empty() ? ""
                        : called.empty()  ? line
                                          : eachOf(called, line))
                    << "\n";
        }
        _open.pop_back();
    }

    void includeNext(const std::string& piece, const ShaderPiece* given,
                     const std::string& includer, std::ostringstream& out)
    {
        out << "#line 0 " << _pieces.size() << "\n";
        include(piece, given, includer, out);
    }

    // In one line, so that those after it keep their numbers.
    std::string eachOf(const std::string& slot, const std::string& line) const
    {
        const std::string statement = line.substr(line.find('"', line.find('"') + 1) + 1);
        std::string text;
        for (const ShaderSlots::Piece& piece : _slots.in(slot))
        {
            std::string call = statement;
            call.replace(call.find(slot + "("), slot.size(), functionOf(*piece));
            text += call;
        }
        return text;
    }

    const ShaderSlots& _slots;
    std::vector<std::string> _pieces;
    std::vector<std::string> _open;
};

} // namespace

const ShaderPiece* osgWaterReflect::libraryPiece(const std::string& file)
{
    static const auto pieces = []
    {
        std::map<std::string, osg::ref_ptr<const ShaderPiece>> all;
        for (const auto& shader : embeddedShaders)
            all[shader.first] = new ShaderPiece(shader.first, shader.second);
        return all;
    }();
    const auto found = pieces.find(file);
    if (found != pieces.end()) return found->second;
    throw std::runtime_error("shader piece " + file + ": expected a file of shaders/, got none");
}

std::string osgWaterReflect::assembleShader(const std::string& name, const ShaderSlots& slots)
{
    return Assembler(slots).run(name);
}

ShaderReplacement::ShaderReplacement(const std::string& name, const std::string& text) : _name(name)
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    if (!replacements.emplace(name, text).second)
        throw std::runtime_error("shader piece " + name + ": expected one replacement, got two");
    ++replacementsGeneration;
}

ShaderReplacement::~ShaderReplacement()
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    replacements.erase(_name);
    ++replacementsGeneration;
}

std::string ShaderReplacement::all()
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    std::string text;
    for (const auto& replacement : replacements)
        text += replacement.first + '\n' + replacement.second;
    return text;
}

unsigned int ShaderReplacement::generation()
{
    return replacementsGeneration;
}
