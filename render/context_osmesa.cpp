#include "render/gl.h"  // before osmesa.h, so that its own gl.h is not used

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <string>
#include <vector>

#include "render/context_kinds.h"
#include "render/error.h"

namespace render {
namespace {

/// OSMesa's functions. The library is loaded with the first context and not with the program: it brings
/// LLVM, which takes longer to load than a command that draws nothing takes to run.
struct Osmesa {
    void* library;
    decltype(&OSMesaCreateContextAttribs) create;
    decltype(&OSMesaMakeCurrent) makeCurrent;
    decltype(&OSMesaDestroyContext) destroy;
    decltype(&OSMesaGetProcAddress) getProcAddress;
};

template <class Function>
void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function) throw Error(std::string("OSMesa has no function ") + name);
}

Osmesa loadOsmesa() {
    Osmesa osmesa{};
    osmesa.library = dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
    if (!osmesa.library)
        throw Error("OSMesa cannot be loaded (libOSMesa.so.8); is libosmesa6 installed?");
    find(osmesa.library, "OSMesaCreateContextAttribs", osmesa.create);
    find(osmesa.library, "OSMesaMakeCurrent", osmesa.makeCurrent);
    find(osmesa.library, "OSMesaDestroyContext", osmesa.destroy);
    find(osmesa.library, "OSMesaGetProcAddress", osmesa.getProcAddress);
    return osmesa;
}

const Osmesa& osmesa() {
    static const Osmesa loaded = loadOsmesa();
    return loaded;
}

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
        context_ = osmesa().create(attributes, nullptr);
        if (!context_)
            throw Error("no OpenGL 3.3 core context from OSMesa; is libosmesa6 installed?");
        // Everything is drawn into our own framebuffers, but OSMesa requires a buffer.
        if (!osmesa().makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) ||
            !gladLoadGL(osmesa().getProcAddress)) {
            osmesa().destroy(context_);
            throw Error("OSMesa could not make its context current");
        }
    }
    ~OsmesaContext() override { osmesa().destroy(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    std::string describe() const override { return describeOpenGl(); }

private:
    static constexpr int kSide = 16;
    OSMesaContext context_ = nullptr;
    std::vector<GLubyte> buffer_ = std::vector<GLubyte>(4 * kSide * kSide);
};

}  // namespace

void loadOsmesaLibrary() { osmesa(); }

std::unique_ptr<Context> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace render
