#ifndef OSGWATERVIEWER_STATUSPAGE_H
#define OSGWATERVIEWER_STATUSPAGE_H

#include "WaterGeodes.h"

#include <osg/Camera>
#include <osgGA/GUIEventHandler>
#include <osgText/Text>

namespace osgwaterviewer
{

/// A page over the picture that tells what was done for the water in the last frame, and why not
/// more, beside osgViewer's own pages of statistics and help. A key shows and hides it.
class StatusPage : public osgGA::GUIEventHandler
{
public:
    explicit StatusPage(const Waters& waters) : _waters(waters) {}

    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;
    void getUsage(osg::ApplicationUsage& usage) const override;

protected:
    ~StatusPage() override = default;

private:
    bool open(osgGA::GUIActionAdapter& action);
    void write();

    const Waters _waters;
    osg::ref_ptr<osg::Camera> _camera; // null until the page is shown first
    osg::ref_ptr<osgText::Text> _text;
};

/// What was done for the waters in the last frame, in lines of text.
std::string statusOf(const Waters& waters);

} // namespace osgwaterviewer

#endif
