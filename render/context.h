/// An OpenGL context without a window, of one of two kinds: OSMesa, or EGL without a surface for
/// systems whose Mesa no longer has OSMesa. Both use the same driver (llvmpipe).
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace render {

/// automatic: osmesa if it works, else egl.
enum class ContextKind { automatic, osmesa, egl };

/// Settings for makeContext().
struct ContextSettings {
    int width = 0, height = 0;                  // pixels, 1..16384
    int threads = -1;                           // of the rasteriser; -1: the driver decides
    bool reproducible = false;                  // restrict all machines to the same CPU features
    ContextKind kind = ContextKind::automatic;  // automatic: OSMesa if it works, else EGL
};

/// Current until it is destroyed.
class Context {
public:
    virtual ~Context() = default;
    /// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6", followed by ", by EGL"
    /// for an EGL context.
    virtual std::string describe() const = 0;
};

/// Makes the context current in this thread and loads the OpenGL functions. Only one context may
/// exist at a time; the next may be of another kind. Throws Error.
std::unique_ptr<Context> makeContext(const ContextSettings& settings);

/// Loads the library of such a context ahead of time. Called before processes that draw are forked, so that
/// they share its memory; errors are left to makeContext(). Throws std::logic_error if this process has made a
/// context: a thread of the driver lives on, and in a forked process its locks would wait for it for ever.
void preloadContext(ContextKind kind);

/// The kinds this program was built with, in the order in which they are tried.
const std::vector<ContextKind>& contextKinds();

const char* nameOf(ContextKind kind);              // "auto", "osmesa", "egl"
ContextKind contextCalled(std::string_view name);  // automatic for an unknown name

}  // namespace render
