#ifndef OSGWATERVIEWER_WATERHANDLER_H
#define OSGWATERVIEWER_WATERHANDLER_H

#include "WaterGeodes.h"

#include <osgGA/GUIEventHandler>

namespace osgwaterviewer
{

/// Keys that change how all waters of the scene look. They are none that osgviewer uses.
class WaterHandler : public osgGA::GUIEventHandler
{
public:
    ///   waves   what the waves' key sets calm water in motion with
    WaterHandler(const Waters& waters, osgWaterReflect::WaveModel* waves) :
        _waters(waters), _waves(waves)
    {
    }

    /// Events are handled between frames, when waters may be changed.
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;
    void getUsage(osg::ApplicationUsage& usage) const override;

protected:
    ~WaterHandler() override = default;

private:
    void switchWater();
    void switchWaves();
    void switchSearch();
    void switchDebugView();

    Waters _waters;
    osg::ref_ptr<osgWaterReflect::WaveModel> _waves;
};

} // namespace osgwaterviewer

#endif
