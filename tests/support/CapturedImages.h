#ifndef OSGWATERREFLECT_TESTS_SUPPORT_CAPTUREDIMAGES_H
#define OSGWATERREFLECT_TESTS_SUPPORT_CAPTUREDIMAGES_H

#include <osg/Camera>
#include <osg/Image>
#include <osg/Texture2D>

#include <vector>

/// What the waters of one camera captured in the frame that was rendered last.
struct CapturedImage
{
    osg::ref_ptr<osg::Image> colour;  ///< bytes where the texture is RGBA8, else floats
    osg::ref_ptr<osg::Image> windowZ; ///< floats
    GLint colourFormat = 0;
    osg::Matrixd clipFromEye;        ///< that it was taken with, for row vectors
    const osg::Camera* of = nullptr; ///< the camera that it was captured for
    bool mirrored = false;           ///< from its eye mirrored in water
};

/// A texture that a camera can render its windowZ to, 24 bits.
osg::ref_ptr<osg::Texture2D> createWindowZTexture(int width, int height);

/// Reads the captures of a view back, in each frame that its camera draws:
///
///     osg::ref_ptr<CapturedImages> captured = CapturedImages::of(view.camera());
///     view.render(scene);
///     captured->one().colour
class CapturedImages : public osg::Camera::DrawCallback
{
public:
    static osg::ref_ptr<CapturedImages> of(osg::Camera& camera);

    void operator()(osg::RenderInfo& renderInfo) const override;

    /// The view's capture; fails the running test where there is not exactly one.
    const CapturedImage& one() const;

    mutable std::vector<CapturedImage> images; ///< that of the view's own camera last
    mutable std::vector<osg::ref_ptr<osg::Texture2D>> textures; ///< that they were read from
    mutable osg::ref_ptr<osg::Image>
        frameWindowZ;                ///< where the camera has a texture for it; floats
    mutable unsigned int stages = 0; ///< that were rendered before the view's, nested ones too
};

/// A copy of an image's lower left part [pixels].
osg::ref_ptr<osg::Image> lowerLeftPart(const osg::Image& image, int width, int height);

#endif
