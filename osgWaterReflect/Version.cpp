#include <osgWaterReflect/Version>

// As text.
#define OSGWATERREFLECT_TEXT_OF(number) #number
#define OSGWATERREFLECT_TEXT(number) OSGWATERREFLECT_TEXT_OF(number)

const char* osgWaterReflectGetVersion()
{
    return OSGWATERREFLECT_TEXT(OSGWATERREFLECT_MAJOR_VERSION) "." OSGWATERREFLECT_TEXT(
        OSGWATERREFLECT_MINOR_VERSION) "." OSGWATERREFLECT_TEXT(OSGWATERREFLECT_PATCH_VERSION);
}

const char* osgWaterReflectGetLibraryName()
{
    return "osgWaterReflect Library";
}
