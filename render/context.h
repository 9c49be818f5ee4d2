/// An OpenGL context without a window, of one of two kinds with the same driver (llvmpipe) behind
/// them: OSMesa, and EGL without a surface, for systems whose Mesa has no OSMesa any more.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace render {

/// automatic: osmesa where it works, else egl.
enum class ContextKind { automatic, osmesa, egl };

/// What makeContext is asked for.
struct ContextSettings {
    int width = 0, height = 0;                  // pixels, 1..16384
    int threads = -1;                           // of the rasteriser; -1: as many as it likes
    bool reproducible = false;                  // one class of CPU features for all machines
    ContextKind kind = ContextKind::automatic;  // automatic: OSMesa where it works, else EGL
};

/// Current as long as it lives.
class Context {
public:
    virtual ~Context() = default;
    /// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6", and ", by EGL" where it
    /// is not OSMesa's.
    virtual std::string describe() const = 0;
};

/// Makes the context current in this thread and loads OpenGL's functions. One at a time: another
/// kind may follow when the first is gone. Throws Error.
std::unique_ptr<Context> makeContext(const ContextSettings& settings);

/// Those this program was built with, in the order in which they are tried.
const std::vector<ContextKind>& contextKinds();

const char* nameOf(ContextKind kind);              // "auto", "osmesa", "egl"
ContextKind contextCalled(std::string_view name);  // automatic where the name is none

}  // namespace render
