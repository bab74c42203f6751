#include "Refusals.h"

class Refusals::Collector : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char* message) override { text += message; }
    std::string text;
};

Refusals::Refusals() :
    _collector(new Collector), _oldHandler(osg::getNotifyHandler()),
    _oldLevel(osg::getNotifyLevel())
{
    osg::setNotifyLevel(osg::WARN);
    osg::setNotifyHandler(_collector);
}

Refusals::~Refusals()
{
    osg::setNotifyHandler(_oldHandler);
    osg::setNotifyLevel(_oldLevel);
}

std::string Refusals::take()
{
    std::string text;
    text.swap(_collector->text);
    return text;
}

bool isRefusalOf(const std::string& member, const std::string& message)
{
    const std::string start = member + ": expected ";
    const std::size_t got = message.find(", got ");
    const bool oneLine = !message.empty() && message.find('\n') == message.size() - 1;
    return message.compare(0, start.size(), start) == 0 && got != std::string::npos &&
           got > start.size() && got + 6 < message.size() - 1 && oneLine;
}
