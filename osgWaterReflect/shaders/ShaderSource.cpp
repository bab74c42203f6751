#include "ShaderSource.h"

#include <algorithm>
#include <mutex>
#include <sstream>
#include <utility>
#include <vector>

using namespace osgWaterReflect;

namespace
{

std::mutex replacementsMutex;
std::map<std::string, std::string> replacements;

// False where there is no such piece.
bool findPiece(const std::string& name, std::string& text)
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    for (const std::map<std::string, std::string>* pieces :
         {&std::as_const(replacements), &embeddedShaders})
    {
        const auto found = pieces->find(name);
        if (found == pieces->end()) continue;
        text = found->second;
        return true;
    }
    return false;
}

class Assembler
{
public:
    explicit Assembler(const std::string& waves) : _waves(waves) {}

    std::string run(const std::string& name)
    {
        std::ostringstream body;
        include(name, "the program", body);

        // #version has to stay first; what the numbers mean comes right after it.
        std::string text = body.str();
        std::ostringstream legend;
        for (std::size_t i = 0; i < _pieces.size(); ++i)
            legend << "// source string " << i << ": " << _pieces[i] << "\n";
        legend << "#line 1 0\n";
        return text.insert(text.find('\n') + 1, legend.str());
    }

private:
    // Until GLSL 3.30 the line after "#line N" counts as N + 1 (its specification, 3.3).
    void include(const std::string& name, const std::string& includer, std::ostringstream& out)
    {
        const std::string piece = name == "waves" ? _waves : name;
        std::string text;
        if (!findPiece(piece, text))
            throw std::runtime_error("shader piece " + piece + ", included by " + includer +
                                     ": expected a file of shaders/, got none");
        if (std::find(_open.begin(), _open.end(), piece) != _open.end())
            throw std::runtime_error("shader piece " + piece + " includes itself");

        const std::size_t number = _pieces.size();
        _pieces.push_back(piece);
        _open.push_back(piece);
        std::istringstream lines(text);
        std::string line;
        for (int lineNumber = 1; std::getline(lines, line); ++lineNumber)
        {
            const std::string directive = "#include \"";
            if (line.compare(0, directive.size(), directive) != 0)
            {
                out << line << "\n";
                continue;
            }
            const std::size_t end = line.find('"', directive.size());
            out << "#line 0 " << _pieces.size() << "\n";
            include(line.substr(directive.size(), end - directive.size()), piece, out);
            out << "#line " << lineNumber << " " << number << "\n";
        }
        _open.pop_back();
    }

    std::string _waves;
    std::vector<std::string> _pieces;
    std::vector<std::string> _open;
};

} // namespace

std::string osgWaterReflect::assembleShader(const std::string& name, const std::string& waves)
{
    return Assembler(waves).run(name);
}

ShaderReplacement::ShaderReplacement(const std::string& name, const std::string& text) : _name(name)
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    if (!replacements.emplace(name, text).second)
        throw std::runtime_error("shader piece " + name + ": expected one replacement, got two");
}

ShaderReplacement::~ShaderReplacement()
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    replacements.erase(_name);
}

std::string ShaderReplacement::all()
{
    const std::lock_guard<std::mutex> lock(replacementsMutex);
    std::string text;
    for (const auto& replacement : replacements)
        text += replacement.first + '\n' + replacement.second;
    return text;
}
