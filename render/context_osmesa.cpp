#include "render/gl.h"  // before osmesa.h, whose own gl.h then stays out

#include <GL/osmesa.h>

#include <cstdlib>
#include <vector>

#include "render/context.h"
#include "render/error.h"

namespace render {
namespace {

constexpr int kMostPixels = 16384;  // a side; OSMesa takes more without a word and draws nothing

/// What a user's environment says to the driver would change pixels or crash it; only we speak.
void prepareEnvironment(const ContextSettings& settings) {
    for (const char* name :
         {"LP_NUM_THREADS", "LP_NATIVE_VECTOR_WIDTH", "LP_DEBUG", "LP_PERF", "LP_NO_RAST",
          "GALLIUM_DRIVER", "GALLIUM_OVERRIDE_CPU_CAPS", "GALLIUM_NOSSE", "GALLIVM_DEBUG",
          "GALLIVM_PERF", "DRAW_USE_LLVM", "MESA_GL_VERSION_OVERRIDE"})
        unsetenv(name);
    if (settings.threads >= 0)
        setenv("LP_NUM_THREADS", std::to_string(settings.threads).c_str(), 1);
    if (settings.reproducible) {
        setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);  // no FMA: the two classes of pixels meet
        setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
    }
}

class OsmesaContext final : public Context {
public:
    explicit OsmesaContext(const ContextSettings& settings) {
        const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 0,
                                  OSMESA_STENCIL_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3,
                                  0};
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!context_) throw Error("no OpenGL 3.3 core context from OSMesa; is libosmesa6 there?");
        // Everything is drawn into framebuffers of our own; OSMesa wants a buffer all the same.
        if (!OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) ||
            !gladLoadGL(OSMesaGetProcAddress)) {
            OSMesaDestroyContext(context_);
            throw Error("OSMesa could not make its " + std::to_string(settings.width) + "x" +
                        std::to_string(settings.height) + " context current");
        }
    }
    ~OsmesaContext() override { OSMesaDestroyContext(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    std::string describe() const override { return glText(GL_RENDERER) + ", " + glText(GL_VERSION); }

private:
    static constexpr int kSide = 16;
    static std::string glText(GLenum name) {
        const GLubyte* text = glGetString(name);
        return text ? reinterpret_cast<const char*>(text) : "unknown";
    }
    OSMesaContext context_ = nullptr;
    std::vector<GLubyte> buffer_ = std::vector<GLubyte>(4 * kSide * kSide);
};

}  // namespace

std::unique_ptr<Context> makeContext(const ContextSettings& settings) {
    for (const int side : {settings.width, settings.height})
        if (side < 1 || side > kMostPixels)
            throw Error("a picture of " + std::to_string(settings.width) + "x" +
                        std::to_string(settings.height) + " pixels cannot be drawn; 1 to " +
                        std::to_string(kMostPixels) + " a side can");
    prepareEnvironment(settings);
    return std::make_unique<OsmesaContext>(settings);
}

}  // namespace render
