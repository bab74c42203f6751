#ifndef OSGWATERREFLECT_TESTS_SUPPORT_SURFACESHAPE_H
#define OSGWATERREFLECT_TESTS_SUPPORT_SURFACESHAPE_H

#include <osg/Drawable>
#include <osg/TriangleFunctor>
#include <osg/Vec3d>

#include <vector>

/// The triangles of a drawable, three corners each, zero areas included.
inline std::vector<osg::Vec3d> trianglesOf(const osg::Drawable& drawable)
{
    struct Collect
    {
        std::vector<osg::Vec3d> corners;
        void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
        {
            corners.insert(corners.end(), {osg::Vec3d(a), osg::Vec3d(b), osg::Vec3d(c)});
        }
    };
    osg::TriangleFunctor<Collect> collect;
    drawable.accept(collect);
    return collect.corners;
}

/// Sum of the triangles' areas as vectors: along the side from which they run counter clockwise.
inline osg::Vec3d areaVectorOf(const std::vector<osg::Vec3d>& triangles)
{
    osg::Vec3d area;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        area += ((triangles[i + 1] - triangles[i]) ^ (triangles[i + 2] - triangles[i])) * 0.5;
    return area;
}

/// Sum of the triangles' areas, whichever way they face.
inline double areaOf(const std::vector<osg::Vec3d>& triangles)
{
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        area +=
            ((triangles[i + 1] - triangles[i]) ^ (triangles[i + 2] - triangles[i])).length() / 2;
    return area;
}

#endif
