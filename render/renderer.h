/// Draws frames off-screen: shadow pass, scene pass, ambient occlusion, overlays, text, read back.
#pragma once
#include <memory>
#include <string>

#include "render/error.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

struct RendererSettings {
    int width = 1280, height = 720;  // pixels, 1..16384
    int samples = 4;                 // per pixel; 1 = no anti-aliasing
    int shadowSize = 2048;           // pixels a side
    int threads = -1;                // of the rasteriser; -1: as many as it likes, 0: the caller's
    bool reproducible = false;       // the same pixels on every x86-64 CPU, for a third more time
};

/// One per process and thread. The first one in a process decides `threads` and `reproducible`.
class Renderer {
public:
    /// Throws Error when there is no OpenGL 3.3 core context, or the size is out of range.
    explicit Renderer(const RendererSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Throws Error when OpenGL reports an error or the picture is all one colour.
    Image draw(const Frame& frame);
    /// Renderer and version, as OpenGL names them.
    std::string describe() const;

private:
    struct Passes;
    std::unique_ptr<Passes> passes_;
};

}  // namespace render
