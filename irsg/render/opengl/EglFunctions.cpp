#include "irsg/render/opengl/EglFunctions.h"

#include <dlfcn.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

InputError notLoaded() {
    const char* why = dlerror();
    return InputError(Diagnostic{"OpenGL", "loading libEGL", why ? why : "not available",
                                 "libEGL.so.1 (package libegl1), or render.engine rays"});
}

EglFunctions load() {
    // Never closed: drivers are not robust against that.
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_GLOBAL);
    if (!library)
        throw notLoaded();
    const auto find = [&]<typename Function>(Function& function, const char* name) {
        function = reinterpret_cast<Function>(dlsym(library, name));
        if (!function)
            throw notLoaded();
    };
    EglFunctions egl;
    find(egl.getProcAddress, "eglGetProcAddress");
    find(egl.getDisplay, "eglGetDisplay");
    find(egl.initialize, "eglInitialize");
    find(egl.bindApi, "eglBindAPI");
    find(egl.chooseConfig, "eglChooseConfig");
    find(egl.createContext, "eglCreateContext");
    find(egl.destroyContext, "eglDestroyContext");
    find(egl.makeCurrent, "eglMakeCurrent");
    return egl;
}

} // namespace

const EglFunctions& EglFunctions::loaded() {
    static const EglFunctions functions = load();
    return functions;
}

} // namespace irsg
