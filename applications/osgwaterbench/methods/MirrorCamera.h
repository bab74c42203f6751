#ifndef OSGWATERBENCH_MIRRORCAMERA_H
#define OSGWATERBENCH_MIRRORCAMERA_H

#include <osg/Camera>
#include <osg/Image>
#include <osg/Plane>
#include <osg/Texture2D>
#include <osg/Vec2d>
#include <osg/Vec3d>

#include <optional>

namespace osgwaterbench
{

/// How a mirrored image is bent by waves.
struct MirrorLook
{
    /// [sizes of the image] how far a place is moved, by how much of the unit normal lies in the
    /// still plane: to the side by shares of the width, up and down by shares of the height.
    double distortion = 0.0;

    /// Near more than far, as three.js does: times (0.001 + 1 / distance), the distance from the
    /// eye in world units.
    bool overDistance = false;
};

/// The scene as the eye mirrored in the water sees it, rendered before the view that the camera is
/// put into: the way that most water reflects. Its children are the scene without the water.
///
/// At a pixel its image shows what that pixel of still water reflects. What is on the other side of
/// the water than the eye is cut off by an oblique near plane [Lengyel05].
///
/// | image   | format       | size       |
/// |---------|--------------|------------|
/// | colour  | as asked for | the view's |
/// | windowZ | 24-bit depth | the same   |
class MirrorCamera : public osg::Camera
{
public:
    /// width, height  [pixels] of the view, which must start at pixel (0, 0)
    MirrorCamera(int width, int height, GLint colourFormat = GL_RGBA8);

    /// Takes up where a perspective view is: to be called before each frame.
    ///   water  still, in world space
    ///   zFar   [world units] nothing farther along the view's axis is drawn. It is given because
    ///          the view's projection has the near and far planes that its last frame was fitted
    ///          with.
    void follow(const osg::Camera& view, const osg::Plane& water, double zFar);

    /// Hands images and bending to water that is drawn by a mirror method.
    void showOn(osg::StateSet& water, const MirrorLook& look) const;

    osg::Texture2D* colour() const { return _colour.get(); }
    osg::Texture2D* windowZ() const { return _windowZ.get(); }

    /// The place of the scene, in world space, that the image shows; none where it shows
    /// background.
    ///   window   [pixels]
    ///   windowZ  the camera's image as it was read back, any format; of the place's pixel
    std::optional<osg::Vec3d> placeAt(const osg::Vec2d& window, const osg::Image& windowZ) const;

protected:
    ~MirrorCamera() override = default;

private:
    osg::ref_ptr<osg::Texture2D> _colour;
    osg::ref_ptr<osg::Texture2D> _windowZ;
};

} // namespace osgwaterbench

#endif
