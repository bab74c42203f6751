#include <osgWaterReflect/SurfaceDetail>

#include "Check.h"

using namespace osgWaterReflect;

bool SurfaceDetail::check() const
{
    if (!expectRange("SurfaceDetail::maxEdgePixels", maxEdgePixels, 1.0, 1024.0)) return false;
    if (!(maxErrorPixels > 0.0 && maxErrorPixels <= 64.0))
        return refuse("SurfaceDetail::maxErrorPixels", "a value in (0, 64]", maxErrorPixels);
    return expectRange("SurfaceDetail::maxVertices", maxVertices, 1000u, 10000000u);
}

bool SurfaceDetail::operator==(const SurfaceDetail& rhs) const
{
    return maxEdgePixels == rhs.maxEdgePixels && maxErrorPixels == rhs.maxErrorPixels &&
           maxVertices == rhs.maxVertices;
}
