#include "ShaderSource.h"

#include <algorithm>
#include <sstream>
#include <vector>

using namespace osgWaterReflect;

namespace
{

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
        const auto found = embeddedShaders.find(piece);
        if (found == embeddedShaders.end())
            throw std::runtime_error("shader piece " + piece + ", included by " + includer +
                                     ": expected a file of shaders/, got none");
        if (std::find(_open.begin(), _open.end(), piece) != _open.end())
            throw std::runtime_error("shader piece " + piece + " includes itself");

        const std::size_t number = _pieces.size();
        _pieces.push_back(piece);
        _open.push_back(piece);
        std::istringstream lines(found->second);
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
