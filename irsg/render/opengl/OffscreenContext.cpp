#include "irsg/render/opengl/OffscreenContext.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/TaskThread.h"
#include "irsg/render/opengl/DriverCache.h"
#include "irsg/render/opengl/EglFunctions.h"
#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

namespace {

InputError unavailable(const std::string& step) {
    return InputError(Diagnostic{"OpenGL", step, "not available on this machine",
                                 "an EGL driver with an OpenGL 4.5 compatibility context "
                                 "(Mesa's software renderer is enough)"});
}

/// An EGL context without a surface.
class EglContext {
  public:
    bool make() {
        for (EGLDisplay display : candidates()) {
            display_ = display;
            if (egl_.initialize(display_, nullptr, nullptr) && create())
                return true;
        }
        return false;
    }
    bool makeCurrent() {
        return egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }
    void close() {
        if (context_ == EGL_NO_CONTEXT)
            return;
        egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_.destroyContext(display_, context_);
        context_ = EGL_NO_CONTEXT;
    }

  private:
    /// Displays to try: real devices first, then Mesa without a surface, then whatever is the
    /// default. IRSG_EGL=software goes straight to Mesa, so that both can be compared on one
    /// machine.
    std::vector<EGLDisplay> candidates() const {
        std::vector<EGLDisplay> displays;
        auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
            egl_.getProcAddress("eglGetPlatformDisplayEXT"));
        const char* wish = std::getenv("IRSG_EGL");
        const bool software = wish && std::strcmp(wish, "software") == 0;
        if (getDisplay && !software)
            for (EGLDeviceEXT device : hardwareDevices())
                displays.push_back(getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        if (getDisplay)
            displays.push_back(
                getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        displays.push_back(egl_.getDisplay(EGL_DEFAULT_DISPLAY));
        std::erase(displays, EGL_NO_DISPLAY);
        return displays;
    }

    /// EGL devices that are not Mesa's software rasterizer, which surfaceless Mesa gives anyway.
    std::vector<EGLDeviceEXT> hardwareDevices() const {
        auto query =
            reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl_.getProcAddress("eglQueryDevicesEXT"));
        auto text = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
            egl_.getProcAddress("eglQueryDeviceStringEXT"));
        EGLint count = 0;
        if (!query || !text || !query(0, nullptr, &count) || count < 1)
            return {};
        std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
        query(count, devices.data(), &count);
        std::erase_if(devices, [&](EGLDeviceEXT device) {
            const char* extensions = text(device, EGL_EXTENSIONS);
            return extensions && std::strstr(extensions, "EGL_MESA_device_software");
        });
        return devices;
    }

    bool create() {
        if (!egl_.bindApi(EGL_OPENGL_API))
            return false;

        const EGLint configWish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                     EGL_NONE};
        EGLConfig config = nullptr;
        EGLint found = 0;
        if (!egl_.chooseConfig(display_, configWish, &config, 1, &found) || found < 1)
            return false;

        const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      4,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                      EGL_NONE};
        context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, contextWish);
        return context_ != EGL_NO_CONTEXT;
    }

    const EglFunctions& egl_ = EglFunctions::loaded();
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

struct OffscreenContext::Impl {
    EglContext egl;
    std::string description;
    int maximumTargetSize = 0;

    TaskThread thread;

    void open() {
        if (!egl.make())
            throw unavailable("creating an off-screen context");
        if (!egl.makeCurrent())
            throw unavailable("making the off-screen context current");

        auto text = [](GLenum name) {
            const GLubyte* value = glGetString(name);
            return value ? std::string(reinterpret_cast<const char*>(value)) : std::string();
        };
        description = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
        GLint size = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
        maximumTargetSize = std::min<GLint>(size, 16384);
    }
};

OffscreenContext& OffscreenContext::shared() {
    // Never destroyed: its thread sleeps when the process ends, after everything that could use it.
    static OffscreenContext* const context = new OffscreenContext;
    return *context;
}

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>()) {
    keepOffFullShaderCache();
    try {
        impl_->thread.post([this] { impl_->open(); }).get();
    } catch (...) {
        impl_->thread.post([this] { impl_->egl.close(); }).get();
        throw;
    }
}

OffscreenContext::~OffscreenContext() {
    impl_->thread.post([this] { impl_->egl.close(); }).get();
}

std::future<void> OffscreenContext::post(std::function<void()> work) {
    return impl_->thread.post(std::move(work));
}

void OffscreenContext::run(const std::function<void()>& work) {
    post(work).get();
}

const std::string& OffscreenContext::rendererDescription() const {
    return impl_->description;
}
int OffscreenContext::maximumTargetSize() const {
    return impl_->maximumTargetSize;
}

} // namespace irsg
