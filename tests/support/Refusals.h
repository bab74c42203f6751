#ifndef OSGWATERREFLECT_TESTS_SUPPORT_REFUSALS_H
#define OSGWATERREFLECT_TESTS_SUPPORT_REFUSALS_H

#include <osg/Notify>
#include <osg/ref_ptr>

#include <string>

/// Collects what is said on OSG_WARN while it lives; puts everything back when it goes.
class Refusals
{
public:
    Refusals();
    ~Refusals();
    Refusals(const Refusals&) = delete;
    Refusals& operator=(const Refusals&) = delete;

    /// What was said since the last call, and forgets it.
    std::string take();

private:
    class Collector;
    osg::ref_ptr<Collector> _collector;
    osg::ref_ptr<osg::NotifyHandler> _oldHandler;
    osg::NotifySeverity _oldLevel;
};

/// Whether a message has the house's form: "Class::member: expected ..., got ...", in one line.
bool isRefusalOf(const std::string& member, const std::string& message);

#endif
