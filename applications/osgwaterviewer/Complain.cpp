#include "Complain.h"

#include <iostream>

bool osgwaterviewer::complain(const std::string& message)
{
    std::cerr << "osgwaterviewer: " << message << std::endl;
    return false;
}
