#include "Progress.h"

#include <osg/Timer>

#include <unistd.h>

#include <iostream>

using namespace osgwaterbench;

namespace
{

const char* const CLEAR_LINE = "\r\033[K";

} // namespace

Progress::Progress(const std::string& what, std::size_t steps) :
    _what(what), _steps(steps), _started(osg::Timer::instance()->time_m()),
    _terminal(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
    const double seconds = 1e-3 * (osg::Timer::instance()->time_m() - _started);
    if (_terminal) std::cerr << CLEAR_LINE;
    std::cerr << _what << ": " << _done << " steps in " << static_cast<int>(seconds + 0.5) << " s"
              << std::endl;
}

void Progress::step(const std::string& name)
{
    ++_done;
    if (_terminal)
        std::cerr << CLEAR_LINE << _what << " " << _done << "/" << _steps << ": " << name
                  << std::flush;
}
