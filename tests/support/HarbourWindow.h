#ifndef OSGWATERREFLECT_TESTS_SUPPORT_HARBOURWINDOW_H
#define OSGWATERREFLECT_TESTS_SUPPORT_HARBOURWINDOW_H

#include "CapturedImages.h"
#include "OffscreenView.h"

/// A view of the harbour that hands out the whole window after all of a frame: an image that a
/// camera writes lacks what is drawn after that camera, and the other eye.
struct HarbourWindow : OffscreenView
{
    static constexpr int WIDTH = 160;
    static constexpr int HEIGHT = 120;

    /// An eye well beside the first, scenes::HARBOUR_EYE.
    inline static const osg::Vec3d OTHER_EYE{-9.0, -9.0, 5.0};

    HarbourWindow();

    /// Renders one frame at time 0; the image stays valid until the next.
    const osg::Image& render(osg::Node* scene);

    osg::ref_ptr<CapturedImages> captured;

private:
    osg::ref_ptr<osg::Image> _pixels;
};

#endif
