#include "OffscreenContext.h"

#include <osg/Notify>

#include <GL/osmesa.h>

#include <vector>

using namespace osgWaterReflect;

namespace
{

class OSMesaGraphicsContext : public OffscreenContext
{
public:
    OSMesaGraphicsContext(int width, int height) :
        OffscreenContext(width, height), _pixels(static_cast<std::size_t>(width) * height * 4)
    {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_STENCIL_BITS,
                                  8,
                                  OSMESA_PROFILE,
                                  OSMESA_COMPAT_PROFILE,
                                  0};
        _context = OSMesaCreateContextAttribs(attributes, nullptr);
    }

    bool valid() const override { return _context != nullptr; }

    bool makeCurrentImplementation() override
    {
        return OSMesaMakeCurrent(_context, _pixels.data(), GL_UNSIGNED_BYTE, _traits->width,
                                 _traits->height);
    }

    bool releaseContextImplementation() override
    {
        return OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }

    void closeImplementation() override
    {
        if (_context) OSMesaDestroyContext(_context);
        _context = nullptr;
    }

protected:
    ~OSMesaGraphicsContext() override { close(); }

private:
    OSMesaContext _context = nullptr;
    std::vector<unsigned char> _pixels;
};

} // namespace

osg::ref_ptr<osg::GraphicsContext> osgWaterReflect::createOffscreenContext(int width, int height)
{
    osg::ref_ptr<osg::GraphicsContext> context = new OSMesaGraphicsContext(width, height);
    if (context->valid()) return context;
    OSG_WARN << "createOffscreenContext: expected an OSMesa context, got none" << std::endl;
    return nullptr;
}
