#ifndef OSGWATERREFLECT_TRANSFORMS_H
#define OSGWATERREFLECT_TRANSFORMS_H

#include <osg/Matrixd>
#include <osg/Matrixf>
#include <osg/Uniform>
#include <osg/Vec2d>
#include <osg/Vec3d>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

/// The one place where matrices change hands. OpenSceneGraph multiplies row vectors, v * A * B;
/// everything here multiplies columns and is named destination first, so that a chain reads
/// clipFromEye * eyeFromWorld * pointWorld and checks itself by eye. Both store the same bytes.
namespace osgWaterReflect
{

inline glm::dmat4 fromOsg(const osg::Matrixd& matrix)
{
    return glm::make_mat4(matrix.ptr());
}

inline osg::Matrixd toOsg(const glm::dmat4& matrix)
{
    return osg::Matrixd(glm::value_ptr(matrix));
}

inline osg::Matrixf toOsgFloat(const glm::dmat4& matrix)
{
    return osg::Matrixf(glm::value_ptr(matrix));
}

inline osg::Matrix3 toOsgFloat(const glm::dmat3& matrix)
{
    osg::Matrix3 single;
    for (int i = 0; i < 9; ++i)
        single.ptr()[i] = static_cast<float>(glm::value_ptr(matrix)[i]);
    return single;
}

inline glm::dvec3 fromOsg(const osg::Vec3d& v)
{
    return glm::dvec3(v.x(), v.y(), v.z());
}

inline osg::Vec3d toOsg(const glm::dvec3& v)
{
    return osg::Vec3d(v.x, v.y, v.z);
}

/// The matrix that carries normals where m carries points: the inverse transpose.
inline glm::dmat3 normalMatrix(const glm::dmat4& m)
{
    return glm::transpose(glm::inverse(glm::dmat3(m)));
}

/// Centre of projection in eye space, homogeneous: (0, 0, 0, 1) in perspective, the direction
/// toward the eye and 0 in an orthographic view.
inline glm::dvec4 eyePointOf(const glm::dmat4& clipFromEye)
{
    const bool orthographic =
        clipFromEye[0][3] == 0.0 && clipFromEye[1][3] == 0.0 && clipFromEye[2][3] == 0.0;
    if (!orthographic) return glm::dvec4(0.0, 0.0, 0.0, 1.0);
    // Along it neither clip x nor clip y changes.
    const glm::dmat4 rows = glm::transpose(clipFromEye);
    const glm::dvec3 along = glm::cross(glm::dvec3(rows[0]), glm::dvec3(rows[1]));
    return glm::dvec4(along.z < 0.0 ? -along : along, 0.0);
}

/// From clip space to clip w times (x, y, 1 - windowZ, 1), x and y in [-1, 1] in the image.
inline glm::dmat4 imageFromClip()
{
    glm::dmat4 image(1.0);
    image[2][2] = -0.5;
    image[3][2] = 0.5;
    return image;
}

/// How windowZ changes between two projections that differ in near and far only, whatever their
/// kind: 1 - windowZ in the second is x + y (1 - windowZ in the first). Counted from the far end,
/// where most of a scene lies, single precision does not run short.
inline glm::dvec2 farGapBetween(const glm::dmat4& firstClipFromEye,
                                const glm::dmat4& secondClipFromEye)
{
    // What takes (z, 1) in eye space to (z, w) in clip space.
    const auto alongView = [](const glm::dmat4& m)
    { return glm::dmat2(m[2][2], m[2][3], m[3][2], m[3][3]); };
    const glm::dmat2 secondFromFirst =
        alongView(secondClipFromEye) * glm::inverse(alongView(firstClipFromEye));
    const double slope = secondFromFirst[0][0] / secondFromFirst[1][1];
    const double ndcZOfMiddle = secondFromFirst[1][0] / secondFromFirst[1][1];
    return glm::dvec2(0.5 * (1.0 - ndcZOfMiddle - slope), slope);
}

} // namespace osgWaterReflect

#endif
