#include "WaterHandler.h"

#include "Names.h"

#include <osgWaterReflect/settings/Members.h>

#include <osg/Notify>

using namespace osgwaterviewer;
using osgWaterReflect::ReflectionSettings;
using osgWaterReflect::Search;
using osgWaterReflect::SEARCHES;
using osgWaterReflect::WaterSurface;

namespace
{

const char WATER_KEY = 'x';
const char WAVES_KEY = 'u';
const char SEARCH_KEY = 'r';
const char DEBUG_KEY = 'd';

void say(const std::string& what, const std::string& now)
{
    OSG_NOTICE << what << ": " << now << std::endl;
}

} // namespace

bool WaterHandler::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action)
{
    if (event.getHandled() || event.getEventType() != osgGA::GUIEventAdapter::KEYDOWN ||
        _waters.empty())
        return false;
    switch (event.getKey())
    {
    case WATER_KEY:
        switchWater();
        break;
    case WAVES_KEY:
        switchWaves();
        break;
    case SEARCH_KEY:
        switchSearch();
        break;
    case DEBUG_KEY:
        switchDebugView();
        break;
    default:
        return false;
    }
    action.requestRedraw();
    return true;
}

void WaterHandler::getUsage(osg::ApplicationUsage& usage) const
{
    const auto add = [&](char key, const char* help)
    { usage.addKeyboardMouseBinding(std::string(1, key), help); };
    add(WATER_KEY, "Toggle the water");
    add(WAVES_KEY, "Toggle between calm and moving water");
    add(SEARCH_KEY, "Switch the search for the water's reflected rays");
    add(DEBUG_KEY, "Switch the water's debug view");
}

void WaterHandler::switchWater()
{
    const bool on = _waters.front()->getNodeMask() == 0;
    for (const osg::ref_ptr<WaterSurface>& water : _waters)
        water->setNodeMask(on ? ~0u : 0u);
    say("water", on ? "on" : "off");
}

void WaterHandler::switchWaves()
{
    const bool moving = !_waters.front()->getWaves();
    for (const osg::ref_ptr<WaterSurface>& water : _waters)
        water->setWaves(moving ? _waves.get() : nullptr);
    say("water", moving ? "moving" : "calm");
}

void WaterHandler::switchSearch()
{
    const Search next = valueAfter(SEARCHES, _waters.front()->getReflection().search);
    for (const osg::ref_ptr<WaterSurface>& water : _waters)
    {
        ReflectionSettings settings = water->getReflection();
        settings.search = next;
        water->setReflection(settings);
    }
    say("search", wordOf(SEARCHES, next));
}

void WaterHandler::switchDebugView()
{
    const WaterSurface::DebugView next = valueAfter(DEBUG_VIEWS, _waters.front()->getDebugView());
    for (const osg::ref_ptr<WaterSurface>& water : _waters)
        water->setDebugView(next);
    say("debug view", wordOf(DEBUG_VIEWS, next));
}
