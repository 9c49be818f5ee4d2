/// An OpenGL context without a window. OSMesa is behind it today; upstream Mesa has dropped it, and an
/// EGL surfaceless context can take its place in one new file.
#pragma once
#include <memory>
#include <string>

namespace render {

struct ContextSettings {
    int width = 0, height = 0;  // pixels, 1..16384
    int threads = -1;           // of the rasteriser; -1: as many as it likes
    bool reproducible = false;  // one class of CPU features for all machines
};

class Context {
public:
    virtual ~Context() = default;
    /// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6"
    virtual std::string describe() const = 0;
};

/// Makes the context current in this thread and loads OpenGL's functions. Throws Error.
std::unique_ptr<Context> makeContext(const ContextSettings& settings);

}  // namespace render
