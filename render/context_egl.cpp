#include "render/gl.h"  // glad first: EGL's headers then find OpenGL's types

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "render/context_kinds.h"
#include "render/error.h"

namespace render {
namespace {

[[noreturn]] void fail(const char* what) {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
    throw Error(std::string("no OpenGL 3.3 core context from EGL: ") + what + " (error " + code +
                "); are libegl-mesa0 and libgl1-mesa-dri installed?");
}

/// No window system, no device file: EGL_MESA_platform_surfaceless.
EGLDisplay openDisplay() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) fail("it has no surfaceless platform");
    if (!eglInitialize(display, nullptr, nullptr)) fail("its display cannot be opened");
    return display;
}

EGLConfig chooseConfig(EGLDisplay display) {
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
        fail("it does not support desktop OpenGL");
    return config;
}

class EglContext final : public Context {
public:
    EglContext() : display_(openDisplay()) {
        try {
            makeCurrent();
        } catch (const Error&) {
            eglTerminate(display_);
            throw;
        }
    }
    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
        eglReleaseThread();
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    std::string describe() const override { return describeOpenGl() + ", by EGL"; }

private:
    /// Without a surface (EGL_KHR_surfaceless_context): all framebuffers are our own.
    void makeCurrent() {
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
        if (!eglBindAPI(EGL_OPENGL_API)) fail("it does not support desktop OpenGL");
        context_ = eglCreateContext(display_, chooseConfig(display_), EGL_NO_CONTEXT, attributes);
        if (context_ == EGL_NO_CONTEXT) fail("its driver cannot create one");
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            fail("it cannot be made current without a surface");
        if (!gladLoadGL(eglGetProcAddress)) fail("functions of OpenGL 3.3 are missing");
    }

    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> makeEglContext() { return std::make_unique<EglContext>(); }

}  // namespace render
