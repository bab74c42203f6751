#ifndef OSGWATERBENCH_PROGRESS_H
#define OSGWATERBENCH_PROGRESS_H

#include <cstddef>
#include <string>

namespace osgwaterbench
{

/// Tells on standard error how far long work has come, on one line that is rewritten; nothing where
/// that is no terminal but the line at the end.
class Progress
{
public:
    Progress(const std::string& what, std::size_t steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A step begins.
    void step(const std::string& name);

private:
    std::string _what;
    std::size_t _steps;
    std::size_t _done = 0;
    double _started; // [ms]
    bool _terminal;
};

} // namespace osgwaterbench

#endif
