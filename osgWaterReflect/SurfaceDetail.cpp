#include <osgWaterReflect/SurfaceDetail>

#include "Check.h"

using namespace osgWaterReflect;

bool SurfaceDetail::check() const
{
    return expectRange("SurfaceDetail::maxEdgePixels", maxEdgePixels, 1.0, 1024.0) &&
           expectRange("SurfaceDetail::maxVertices", maxVertices, 1000u, 10000000u);
}

bool SurfaceDetail::operator==(const SurfaceDetail& rhs) const
{
    return maxEdgePixels == rhs.maxEdgePixels && maxVertices == rhs.maxVertices;
}
