#include "render/gl.h"  // before osmesa.h, so that its own gl.h is not used

#include <GL/osmesa.h>

#include <vector>

#include "render/context_kinds.h"
#include "render/error.h"

namespace render {
namespace {

class OsmesaContext final : public Context {
public:
    OsmesaContext() {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_STENCIL_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!context_)
            throw Error("no OpenGL 3.3 core context from OSMesa; is libosmesa6 installed?");
        // Everything is drawn into our own framebuffers, but OSMesa requires a buffer.
        if (!OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) ||
            !gladLoadGL(OSMesaGetProcAddress)) {
            OSMesaDestroyContext(context_);
            throw Error("OSMesa could not make its context current");
        }
    }
    ~OsmesaContext() override { OSMesaDestroyContext(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    std::string describe() const override { return describeOpenGl(); }

private:
    static constexpr int kSide = 16;
    OSMesaContext context_ = nullptr;
    std::vector<GLubyte> buffer_ = std::vector<GLubyte>(4 * kSide * kSide);
};

}  // namespace

std::unique_ptr<Context> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace render
