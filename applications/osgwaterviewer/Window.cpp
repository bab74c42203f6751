#include "Window.h"

#include "Complain.h"
#include "StatusPage.h"
#include "WaterHandler.h"

#include <osgGA/AnimationPathManipulator>
#include <osgGA/DriveManipulator>
#include <osgGA/FirstPersonManipulator>
#include <osgGA/FlightManipulator>
#include <osgGA/KeySwitchMatrixManipulator>
#include <osgGA/OrbitManipulator>
#include <osgGA/SphericalManipulator>
#include <osgGA/StateSetManipulator>
#include <osgGA/TerrainManipulator>
#include <osgGA/TrackballManipulator>
#include <osgViewer/ViewerEventHandlers>

using namespace osgwaterviewer;

void osgwaterviewer::addHandlers(osgViewer::Viewer& viewer, osg::ApplicationUsage* usage,
                                 const Waters& waters, osgWaterReflect::WaveModel* waves)
{
    viewer.addEventHandler(
        new osgGA::StateSetManipulator(viewer.getCamera()->getOrCreateStateSet()));
    viewer.addEventHandler(new osgViewer::ThreadingHandler);
    viewer.addEventHandler(new osgViewer::WindowSizeHandler);
    viewer.addEventHandler(new osgViewer::StatsHandler);
    viewer.addEventHandler(new osgViewer::HelpHandler(usage));
    viewer.addEventHandler(new osgViewer::RecordCameraPathHandler);
    viewer.addEventHandler(new osgViewer::LODScaleHandler);
    viewer.addEventHandler(new osgViewer::ScreenCaptureHandler);
    viewer.addEventHandler(new WaterHandler(waters, waves));
    viewer.addEventHandler(new StatusPage(waters));
}

bool osgwaterviewer::addManipulators(osgViewer::Viewer& viewer, const HomeView& home,
                                     const std::string& pathFile)
{
    const osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> keys =
        new osgGA::KeySwitchMatrixManipulator;
    keys->addMatrixManipulator('1', "Trackball", new osgGA::TrackballManipulator);
    keys->addMatrixManipulator('2', "Flight", new osgGA::FlightManipulator);
    keys->addMatrixManipulator('3', "Drive", new osgGA::DriveManipulator);
    keys->addMatrixManipulator('4', "Terrain", new osgGA::TerrainManipulator);
    keys->addMatrixManipulator('5', "Orbit", new osgGA::OrbitManipulator);
    keys->addMatrixManipulator('6', "FirstPerson", new osgGA::FirstPersonManipulator);
    keys->addMatrixManipulator('7', "Spherical", new osgGA::SphericalManipulator);
    if (!pathFile.empty())
    {
        const osg::ref_ptr<osgGA::AnimationPathManipulator> path =
            new osgGA::AnimationPathManipulator(pathFile);
        if (!path->valid() || path->getAnimationPath()->empty())
            return complain(pathFile + ": expected a camera path, got none that can be read");
        keys->addMatrixManipulator('8', "Path", path);
        keys->selectMatrixManipulator(keys->getNumMatrixManipulators() - 1);
    }
    keys->setHomePosition(home.eye, home.centre, home.up());
    viewer.setCameraManipulator(keys);
    return true;
}

int osgwaterviewer::runInWindow(osgViewer::Viewer& viewer, const Scene& scene)
{
    setFovyDegrees(*viewer.getCamera(), scene.fovyDegrees);
    viewer.setSceneData(scene.root);
    viewer.realize();
    if (!viewer.isRealized())
    {
        complain("expected a display to open a window on, got none; --offscreen needs none");
        return 1;
    }
    return viewer.run();
}
