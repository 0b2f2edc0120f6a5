#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace irsg {

/// The functions of libEGL that off-screen drawing calls. The library is loaded when they are first
/// asked for, so that a machine without it can do whatever needs no drawing.
struct EglFunctions {
    decltype(&::eglGetProcAddress) getProcAddress = nullptr;
    decltype(&::eglGetDisplay) getDisplay = nullptr;
    decltype(&::eglInitialize) initialize = nullptr;
    decltype(&::eglBindAPI) bindApi = nullptr;
    decltype(&::eglChooseConfig) chooseConfig = nullptr;
    decltype(&::eglCreateContext) createContext = nullptr;
    decltype(&::eglDestroyContext) destroyContext = nullptr;
    decltype(&::eglMakeCurrent) makeCurrent = nullptr;

    /// Throws InputError where the machine has no libEGL.
    static const EglFunctions& loaded();
};

} // namespace irsg
