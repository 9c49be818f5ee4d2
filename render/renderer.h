/// Frame (values) -> Image (pixels), without a display.
#pragma once
#include <memory>
#include <string>

#include "render/error.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

inline constexpr int kMaximumSize = 16384;  // pixels a side; OSMesa takes more and draws nonsense

struct RendererSettings {
    int width = 1280, height = 720;  // pixels, 1..kMaximumSize
    int samples = 4;                 // per pixel: 4 (smooth edges) or 1 (drafts, half the time)
    int shadowSize = 2048;           // texels a side of the shadow map, 256..8192
    bool reproducible = false;       // the same bits on every x86-64 CPU, for about a third more time
    int threads = -1;                // of the rasteriser; 0 = this thread only, -1 = Mesa's choice
};

/// CPU milliseconds, for tables and `doctor`; draw() fills it in when asked to.
struct PassTimes {
    double upload = 0, shadow = 0, scene = 0, resolve = 0, occlusion = 0, overlay = 0, read = 0,
           text = 0;
};

/// One renderer, one size, one thread. `reproducible` and `threads` hold for the whole process: the
/// first renderer decides. For many cores use processes, forked before their first renderer; two
/// renderers in two threads of one process wait for each other.
class Renderer {
   public:
    explicit Renderer(const RendererSettings& settings = {});  // throws Error
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// The same frame gives the same bytes. Throws Error: a value that is not finite, a camera
    /// without a direction, a failure of GL, a picture of one single colour.
    Image draw(const Frame& frame);

    /// As draw, and waits after every pass to tell what each took (CPU of all threads, ms).
    Image drawTimed(const Frame& frame, PassTimes& times);

    /// Vendor, driver and version, one line.
    std::string describe() const;

   private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Bytes a renderer of these settings will need, roughly; to refuse before the first frame.
std::size_t memoryNeeded(const RendererSettings& settings);

}  // namespace render
