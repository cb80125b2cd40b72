// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/egl_context.h"

#define EGL_NO_X11
#include <dlfcn.h>
#include <EGL/egl.h>
#include <EGL/eglext.h>

// Debian's GLEW is the GLX build: without a current GLX display its glewInit reports "no GLX display"
// although every entry point was loaded. VTK would then log an error and initialise again in every frame.
// This definition in the executable is found before the library's and turns that one result into success. It
// lives in this file so that a static library cannot drop it while the context is in use.
extern "C" __attribute__((visibility("default"))) unsigned int glewInit() {
    constexpr unsigned int noGlxDisplay = 4;
    using Function = unsigned int (*)();
    static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glewInit"));
    if (!original) return 1;
    const unsigned int result = original();
    return result == noGlxDisplay ? 0 : result;
}

namespace isoscope {

std::shared_ptr<EglContext> EglContext::shared() {
    static std::weak_ptr<EglContext> current;
    if (auto existing = current.lock()) return existing;
    std::shared_ptr<EglContext> made(new EglContext);
    current = made;
    return made;
}

EglContext::EglContext() {
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay)
        display_ = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!display_ || !eglInitialize(display_, nullptr, nullptr)) {
        problem_ = "EGL has no surfaceless platform on this machine";
        return;
    }
    const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, configAttributes, &config, 1, &count) ||
        count == 0) {
        problem_ = "EGL offers no desktop OpenGL on this machine";
        return;
    }
    const EGLint contextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        2,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, contextAttributes);
    if (!context_) problem_ = "OpenGL 3.2 is not available on this machine";
}

EglContext::~EglContext() {
    if (context_) {
        if (isCurrent()) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    // The display is shared by everything in the process that asks EGL for it, so it is not terminated.
}

bool EglContext::makeCurrent() {
    return valid() && (isCurrent() || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_));
}

bool EglContext::isCurrent() const { return valid() && eglGetCurrentContext() == context_; }

}  // namespace isoscope
