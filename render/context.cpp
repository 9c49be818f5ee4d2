#include "render/context.h"

#include <stdexcept>

#include "render/context_kinds.h"
#include "render/driver_environment.h"
#include "render/error.h"

namespace render {
namespace {

bool anyMade = false;  // in this process

constexpr int kMostPixels = 16384;  // per side; OSMesa accepts more but draws nothing

void checkSides(const ContextSettings& settings) {
    for (const int side : {settings.width, settings.height})
        if (side < 1 || side > kMostPixels)
            throw Error("cannot draw a picture of " + std::to_string(settings.width) + "x" +
                        std::to_string(settings.height) + ": each side must be within 1.." +
                        std::to_string(kMostPixels) + " pixels");
}

std::unique_ptr<Context> make(ContextKind kind) {
#ifdef IMPULSE_HAVE_OSMESA
    if (kind == ContextKind::osmesa) return makeOsmesaContext();
#endif
#ifdef IMPULSE_HAVE_EGL
    if (kind == ContextKind::egl) return makeEglContext();
#endif
    throw Error(std::string("this program was built without the context '") + nameOf(kind) +
                "'; 'auto' selects one that it has");
}

/// The first kind that works. If none does, throws the first one's error.
std::unique_ptr<Context> makeAny() {
    std::string reason;
    for (const ContextKind kind : contextKinds()) {
        try {
            return make(kind);
        } catch (const Error& error) {
            if (reason.empty()) reason = error.what();
        }
    }
    throw Error(reason);
}

}  // namespace

const std::vector<ContextKind>& contextKinds() {
    static const std::vector<ContextKind> kinds = {
#ifdef IMPULSE_HAVE_OSMESA
        ContextKind::osmesa,
#endif
#ifdef IMPULSE_HAVE_EGL
        ContextKind::egl,
#endif
    };
    return kinds;
}

const char* nameOf(ContextKind kind) {
    switch (kind) {
        case ContextKind::automatic:
            return "auto";
        case ContextKind::osmesa:
            return "osmesa";
        case ContextKind::egl:
            return "egl";
    }
    return "unknown";
}

ContextKind contextCalled(std::string_view name) {
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl})
        if (name == nameOf(kind)) return kind;
    return ContextKind::automatic;
}

void preloadContext([[maybe_unused]] ContextKind kind) {
    if (anyMade) throw std::logic_error("processes that draw are forked before the first context is made");
#ifdef IMPULSE_HAVE_OSMESA
    if (kind == ContextKind::egl) return;
    try {
        loadOsmesaLibrary();
    } catch (const Error&) {
        return;
    }
#endif
}

std::unique_ptr<Context> makeContext(const ContextSettings& settings) {
    checkSides(settings);
    prepareDriverEnvironment(settings);
    anyMade = true;
    return settings.kind == ContextKind::automatic ? makeAny() : make(settings.kind);
}

}  // namespace render
