#ifndef OSGWATERREFLECT_SURFACE_OUTLINEGEOMETRY_H
#define OSGWATERREFLECT_SURFACE_OUTLINEGEOMETRY_H

#include <osg/Geometry>

#include <vector>

namespace osgWaterReflect
{

/// The drawables of WaterSurface::createRectangle and WaterSurface::createPolygon, which say what
/// is asked for. Null, with a message that names the member, where it is not given.
osg::ref_ptr<osg::Geometry> createRectangleGeometry(const char* member, const osg::Vec3& centre,
                                                    const osg::Vec3& lengthVec,
                                                    const osg::Vec3& widthVec);
osg::ref_ptr<osg::Geometry> createPolygonGeometry(const char* member,
                                                  const std::vector<osg::Vec3>& outline,
                                                  const std::vector<std::vector<osg::Vec3>>& holes);

} // namespace osgWaterReflect

#endif
