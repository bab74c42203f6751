#ifndef OSGWATERVIEWER_COMPLAIN_H
#define OSGWATERVIEWER_COMPLAIN_H

#include <string>

namespace osgwaterviewer
{

/// Says in one line on stderr why the program cannot go on. Returns false, for the caller to hand
/// on.
bool complain(const std::string& message);

} // namespace osgwaterviewer

#endif
