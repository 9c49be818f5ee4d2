// The only file that knows OSMesa.
#include "render/context.h"
#include "render/error.h"
#include "render/gl.h"

// After glad: osmesa.h would otherwise bring its own gl.h.
#include <GL/osmesa.h>

#include <array>
#include <string>

namespace render {
namespace {

std::string glText(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? std::string(reinterpret_cast<const char*>(text)) : std::string("?");
}

class OsmesaContext final : public Context {
   public:
    OsmesaContext(int width, int height) : Context(width, height) {
        static constexpr std::array<int, 9> kAttributes{OSMESA_FORMAT,
                                                        OSMESA_RGBA,
                                                        OSMESA_PROFILE,
                                                        OSMESA_CORE_PROFILE,
                                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                                        3,
                                                        OSMESA_CONTEXT_MINOR_VERSION,
                                                        3,
                                                        0};
        context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
        if (context_ == nullptr)
            throw Error("renderer: OSMesa gives no OpenGL 3.3 core context; Mesa 22 does");
    }
    ~OsmesaContext() override { OSMesaDestroyContext(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    bool makeCurrent() override {
        if (OSMesaGetCurrentContext() == context_) return true;
        // Everything is drawn into framebuffer objects: the context's own buffer is never used.
        return OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }

    std::string describe() const override {
        return "OSMesa, " + glText(GL_RENDERER) + ", " + glText(GL_VERSION);
    }

   private:
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> pixel_{};
};

}  // namespace

std::unique_ptr<Context> makeContext(int width, int height) {
    auto context = std::make_unique<OsmesaContext>(width, height);
    if (!context->makeCurrent())
        throw Error("renderer: OSMesa refuses to make its context current");
    const int version = gladLoadGL(OSMesaGetProcAddress);
    if (version < GLAD_MAKE_VERSION(3, 3))
        throw Error("renderer: OSMesa offers OpenGL " + glText(GL_VERSION) + "; 3.3 is needed");
    return context;
}

}  // namespace render
