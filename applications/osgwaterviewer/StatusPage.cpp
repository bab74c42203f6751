#include "StatusPage.h"

#include <osgViewer/Renderer>
#include <osgViewer/View>

#include <sstream>

using namespace osgwaterviewer;

namespace
{

const char KEY = 'i';

// [pixels] Of the page's text, and of its margin.
const float CHARACTER_SIZE = 14.0f;
const float MARGIN = 12.0f;

// After all that the view draws, osgViewer's help (11) too.
const int ORDER = 12;

osg::ref_ptr<osgText::Text> createText()
{
    const osg::ref_ptr<osgText::Text> text = new osgText::Text;
    text->setDataVariance(osg::Object::DYNAMIC);
    text->setFont("fonts/arial.ttf"); // as osgViewer's pages have it; else OSG's own
    text->setCharacterSize(CHARACTER_SIZE);
    text->setAlignment(osgText::Text::LEFT_TOP);
    text->setColor(osg::Vec4(1.0f, 1.0f, 1.0f, 1.0f));
    text->setBackdropType(osgText::Text::OUTLINE);
    text->setBackdropColor(osg::Vec4(0.0f, 0.0f, 0.0f, 1.0f));
    return text;
}

} // namespace

std::string osgwaterviewer::statusOf(const Waters& waters)
{
    std::ostringstream lines;
    for (std::size_t i = 0; i < waters.size(); ++i)
        for (const osgWaterReflect::WaterStatus& status : waters[i]->getStatus())
            lines << "water " << i << ", " << status;
    return lines.str();
}

bool StatusPage::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action)
{
    const bool shown = _camera && _camera->getNodeMask() != 0;
    if (event.getEventType() == osgGA::GUIEventAdapter::FRAME && shown) write();
    if (event.getHandled() || event.getEventType() != osgGA::GUIEventAdapter::KEYDOWN ||
        event.getKey() != KEY)
        return false;
    if (!_camera && !open(action)) return false;
    _camera->setNodeMask(shown ? 0 : ~0u);
    write();
    action.requestRedraw();
    return true;
}

void StatusPage::getUsage(osg::ApplicationUsage& usage) const
{
    usage.addKeyboardMouseBinding(
        std::string(1, KEY),
        "Show what was done for the water in the last frame, and why not more");
}

// A camera of its own in the view's window, as osgViewer's pages have: what it draws is not in the
// scene, and water does not reflect it.
bool StatusPage::open(osgGA::GUIActionAdapter& action)
{
    auto* const view = dynamic_cast<osgViewer::View*>(action.asView());
    osgViewer::ViewerBase* const viewer = view ? view->getViewerBase() : nullptr;
    if (!viewer) return false;
    osgViewer::ViewerBase::Windows windows;
    viewer->getWindows(windows);
    if (windows.empty()) return false;
    const osg::GraphicsContext::Traits& traits = *windows.front()->getTraits();

    _text = createText();
    _text->setPosition(osg::Vec3(MARGIN, traits.height - MARGIN, 0.0f));
    _camera = new osg::Camera;
    _camera->setName("status page");
    _camera->setNodeMask(0);
    _camera->setGraphicsContext(windows.front());
    _camera->setViewport(0, 0, traits.width, traits.height);
    _camera->setRenderOrder(osg::Camera::POST_RENDER, ORDER);
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setProjectionMatrixAsOrtho2D(0, traits.width, 0, traits.height);
    _camera->setClearMask(0);
    _camera->setAllowEventFocus(false);
    _camera->setRenderer(new osgViewer::Renderer(_camera));
    _camera->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    _camera->getOrCreateStateSet()->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    _camera->addChild(_text);
    return true;
}

void StatusPage::write()
{
    _text->setText(statusOf(_waters));
}
