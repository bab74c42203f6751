#include "MirrorCamera.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/shaders/Bindings.h>

#include <osg/FrontFace>

#include <glm/matrix.hpp>

using namespace osgWaterReflect;
using namespace osgwaterbench;

namespace
{

// shaders/reflection_mirror.glsl has the same names.
constexpr const char* COLOUR = "bench_mirrorColour";
constexpr const char* WINDOW_Z = "bench_mirrorWindowZ";
constexpr const char* DISTORTION = "bench_mirrorDistortion";
constexpr unsigned int UNIT_COLOUR = bindings::NUM_UNITS;
constexpr unsigned int UNIT_WINDOW_Z = UNIT_COLOUR + 1;

// What three.js bends the image by at any distance, over what it does at a distance of 1.
const double DISTORTION_FAR_AWAY = 0.001;

osg::ref_ptr<osg::Texture2D> createImage(int width, int height, GLint internalFormat, GLenum format)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(width, height);
    texture->setInternalFormat(internalFormat);
    texture->setSourceFormat(format);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

// Reflection in a plane (unit normal, and distance of the origin from it).
glm::dmat4 mirrorIn(const glm::dvec4& plane)
{
    const glm::dvec3 normal(plane);
    glm::dmat4 mirror(glm::dmat3(1.0) - 2.0 * glm::outerProduct(normal, normal));
    mirror[3] = glm::dvec4(-2.0 * plane.w * normal, 1.0);
    return mirror;
}

// A perspective projection whose near plane is another one, its far plane moved no nearer than it
// must be to leave nothing out up to a depth [Lengyel05].
//   plane  in eye space; positive on the side that is kept, where the eye is not
glm::dmat4 withNearPlane(const glm::dmat4& clipFromEye, const glm::dvec4& planeEye, double zFar)
{
    // The corner of the far plane that is farthest from the plane.
    const glm::dmat4 eyeFromClip = glm::inverse(clipFromEye);
    const glm::dvec4 planeClip = glm::transpose(eyeFromClip) * planeEye;
    const glm::dvec4 corner = eyeFromClip * glm::dvec4(planeClip.x < 0.0 ? -1.0 : 1.0,
                                                       planeClip.y < 0.0 ? -1.0 : 1.0, 1.0, 1.0);
    const glm::dvec4 farCorner(glm::dvec3(corner) * (-zFar / corner.z), 1.0);

    glm::dmat4 rows = glm::transpose(clipFromEye);
    const double scale = 2.0 * glm::dot(rows[3], farCorner) / glm::dot(planeEye, farCorner);
    rows[2] = scale * planeEye - rows[3];
    return glm::transpose(rows);
}

} // namespace

MirrorCamera::MirrorCamera(int width, int height, GLint colourFormat) :
    _colour(createImage(width, height, colourFormat, GL_RGBA)),
    _windowZ(createImage(width, height, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT))
{
    setName("osgwaterbench mirror");
    setRenderOrder(osg::Camera::PRE_RENDER);
    setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    setImplicitBufferAttachmentMask(0, 0);
    attach(osg::Camera::COLOR_BUFFER0, _colour);
    attach(osg::Camera::DEPTH_BUFFER, _windowZ);
    setViewport(0, 0, width, height);
    setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    // OSG would refit an oblique near plane as if it were none, and cull by it.
    setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    setCullingMode(osg::CullSettings::VIEW_FRUSTUM_SIDES_CULLING);
    // A mirror turns every triangle round.
    getOrCreateStateSet()->setAttribute(new osg::FrontFace(osg::FrontFace::CLOCKWISE));
}

void MirrorCamera::follow(const osg::Camera& view, const osg::Plane& water, double zFar)
{
    const glm::dmat4 eyeFromWorld = fromOsg(view.getViewMatrix());
    glm::dvec4 plane(water[0], water[1], water[2], water[3]);
    const glm::dvec4 eye = glm::inverse(eyeFromWorld)[3];
    if (glm::dot(plane, eye) < 0.0) plane = -plane; // the eye's side is kept

    const glm::dmat4 mirroredEyeFromWorld = eyeFromWorld * mirrorIn(plane);
    const glm::dvec4 planeEye = glm::transpose(glm::inverse(mirroredEyeFromWorld)) * plane;
    setViewMatrix(toOsg(mirroredEyeFromWorld));
    setProjectionMatrix(toOsg(withNearPlane(fromOsg(view.getProjectionMatrix()), planeEye, zFar)));
    setClearColor(view.getClearColor());
}

void MirrorCamera::showOn(osg::StateSet& water, const MirrorLook& look) const
{
    water.setTextureAttribute(UNIT_COLOUR, _colour);
    water.setTextureAttribute(UNIT_WINDOW_Z, _windowZ);
    bindings::set(water, COLOUR, static_cast<int>(UNIT_COLOUR));
    bindings::set(water, WINDOW_Z, static_cast<int>(UNIT_WINDOW_Z));
    const double everywhere = look.overDistance ? DISTORTION_FAR_AWAY : 1.0;
    const double timesDistance = look.overDistance ? 1.0 : 0.0;
    bindings::set(water, DISTORTION, osg::Vec2(everywhere, timesDistance) * look.distortion);
}

std::optional<osg::Vec3d> MirrorCamera::placeAt(const osg::Vec2d& window,
                                                const osg::Image& windowZ) const
{
    const double z =
        windowZ.getColor(static_cast<int>(window.x()), static_cast<int>(window.y())).r();
    if (z >= 1.0) return std::nullopt;
    const glm::dvec3 ndc = 2.0 * glm::dvec3(window.x() / _windowZ->getTextureWidth(),
                                            window.y() / _windowZ->getTextureHeight(), z) -
                           1.0;
    const glm::dmat4 clipFromWorld = fromOsg(getProjectionMatrix()) * fromOsg(getViewMatrix());
    const glm::dvec4 world = glm::inverse(clipFromWorld) * glm::dvec4(ndc, 1.0);
    return toOsg(glm::dvec3(world) / world.w);
}
