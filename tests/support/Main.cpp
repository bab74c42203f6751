#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "Catch.h"

#include <osg/Notify>

int main(int argc, char** argv)
{
    // Refusals are asked for by many tests; only what no test asked for is worth reading.
    osg::setNotifyLevel(osg::FATAL);
    return Catch::Session().run(argc, argv);
}
