#include "OffscreenContext.h"

#include <osg/Notify>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vector>

using namespace osgWaterReflect;

namespace
{

EGLDisplay initialized(EGLDisplay display)
{
    if (display == EGL_NO_DISPLAY) return display;
    return eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

// A display without a window system: the first GPU that EGL lists, else Mesa's surfaceless
// platform.
EGLDisplay openDisplay()
{
    const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (!getPlatformDisplay) return initialized(eglGetDisplay(EGL_DEFAULT_DISPLAY));

    EGLint count = 0;
    if (queryDevices && queryDevices(0, nullptr, &count) && count > 0)
    {
        std::vector<EGLDeviceEXT> devices(count);
        queryDevices(count, devices.data(), &count);
        for (EGLDeviceEXT device : devices)
        {
            const EGLDisplay display =
                initialized(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
            if (display != EGL_NO_DISPLAY) return display;
        }
    }
    return initialized(getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                                          reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr));
}

class EGLGraphicsContext : public OffscreenContext
{
public:
    EGLGraphicsContext(int width, int height) : OffscreenContext(width, height)
    {
        _display = openDisplay();
        if (_display == EGL_NO_DISPLAY || !eglBindAPI(EGL_OPENGL_API)) return;

        const EGLint configAttributes[] = {EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_BIT,
                                           EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_ALPHA_SIZE,
                                           8,
                                           EGL_DEPTH_SIZE,
                                           24,
                                           EGL_STENCIL_SIZE,
                                           8,
                                           EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(_display, configAttributes, &config, 1, &count) || count < 1) return;

        const EGLint surfaceAttributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        _surface = eglCreatePbufferSurface(_display, config, surfaceAttributes);
        _context = eglCreateContext(_display, config, EGL_NO_CONTEXT, nullptr);
    }

    bool valid() const override { return _surface != EGL_NO_SURFACE && _context != EGL_NO_CONTEXT; }

    bool makeCurrentImplementation() override
    {
        return eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(_display, _surface, _surface, _context);
    }

    bool releaseContextImplementation() override
    {
        return eglMakeCurrent(_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

    void closeImplementation() override
    {
        if (_context != EGL_NO_CONTEXT) eglDestroyContext(_display, _context);
        if (_surface != EGL_NO_SURFACE) eglDestroySurface(_display, _surface);
        _context = EGL_NO_CONTEXT;
        _surface = EGL_NO_SURFACE;
    }

protected:
    ~EGLGraphicsContext() override { close(); }

private:
    EGLDisplay _display = EGL_NO_DISPLAY;
    EGLSurface _surface = EGL_NO_SURFACE;
    EGLContext _context = EGL_NO_CONTEXT;
};

} // namespace

osg::ref_ptr<osg::GraphicsContext> osgWaterReflect::createOffscreenContext(int width, int height)
{
    osg::ref_ptr<osg::GraphicsContext> context = new EGLGraphicsContext(width, height);
    if (context->valid()) return context;
    OSG_WARN << "createOffscreenContext: expected an EGL context, got none (EGL error 0x"
             << std::hex << eglGetError() << std::dec << ")" << std::endl;
    return nullptr;
}
