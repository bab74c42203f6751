#ifndef OSGWATERREFLECT_TESTS_SUPPORT_SCENES_H
#define OSGWATERREFLECT_TESTS_SUPPORT_SCENES_H

#include <osgWaterReflect/WaterSurface>

#include <osg/Group>
#include <osg/Texture2D>

/// Scenes that several tests share. Metres, z up.
namespace scenes
{

/// Boxes, balls and posts about the origin, some standing in the water, some hanging over it:
/// textured, and lit by the view's head light and by a lamp of the scene's own. No two of its faces
/// coincide, so that a picture of it does not depend on the order of drawing.
osg::ref_ptr<osg::Group> createHarbour();

/// The eye from which most tests look at the harbour, and where it looks.
const osg::Vec3d HARBOUR_EYE(1.0, -14.0, 3.5);
const osg::Vec3d HARBOUR_CENTRE(0.0, 0.0, 0.5);

/// The same water, reflecting what its rays hit in the view's own image: as the tests of the search
/// and of that capture ask for, which leave nothing to the library's choice.
osg::ref_ptr<osgWaterReflect::WaterSurface>
inView(const osg::ref_ptr<osgWaterReflect::WaterSurface>& water);

/// Calm square water about the origin, inView().
osg::ref_ptr<osgWaterReflect::WaterSurface> createLake(double level = 0.0, double size = 60.0);

/// The same water, its captures no wider than the view.
osg::ref_ptr<osgWaterReflect::WaterSurface>
withoutBand(const osg::ref_ptr<osgWaterReflect::WaterSurface>& water);

/// Boxes that stand in the water, near and far along +y, and one that hangs over it.
osg::ref_ptr<osg::Group> createBoxes();

/// Calm level water below the boxes, farther than they reach, inView().
osg::ref_ptr<osgWaterReflect::WaterSurface> createBoxesWater();

/// A plain magenta rectangle where createLake() has water: a picture with it tells which pixels
/// show the water.
osg::ref_ptr<osg::Node> createStandIn();

/// Number of pixels whose colours differ by more than a tolerance in any channel, though a picture
/// with the stand-in shows no water there.
int countDifferentOutsideStandIn(const osg::Image& withStandIn, const osg::Image& a,
                                 const osg::Image& b, double tolerance = 0.0);

/// A box of one colour that no light changes.
osg::ref_ptr<osg::Node> createBox(const osg::Vec3& centre, const osg::Vec3& size,
                                  const osg::Vec4& colour);

/// An upright or lying rectangle of one colour that no light changes, from a corner along its
/// sides.
osg::ref_ptr<osg::Node> createQuad(const osg::Vec3& corner, const osg::Vec3& widthVec,
                                   const osg::Vec3& heightVec, const osg::Vec4& colour);

/// Squares of two colours, 8 by 8.
osg::ref_ptr<osg::Texture2D> createChequers();

/// A group of these nodes.
osg::ref_ptr<osg::Group> together(std::initializer_list<osg::ref_ptr<osg::Node>> nodes);

} // namespace scenes

#endif
