/// Draws frames off-screen: depths, ambient occlusion, shadows, the scene, overlays, text.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "render/context.h"
#include "render/error.h"
#include "render/frame.h"
#include "render/image.h"
#include "render/surface_map.h"

namespace render {

/// The quality of a picture.
enum class Finish {
    draft,    // one sample per pixel, light per vertex, no shadows: to check a scene quickly
    standard  // shadows, ambient occlusion, `samples` per pixel at edges
};

/// Settings of a Renderer.
struct RendererSettings {
    int width = 1280, height = 720;  // pixels, 1..16384
    int samples = 8;                 // per pixel with an edge: 1, 2, 4, 8 or 16; 1: jagged edges
    int shadowSize = 0;              // texels per side of the shadow map; 0: by the picture's size
    Finish finish = Finish::standard;
    int threads = -1;           // of the rasteriser; -1: the driver decides, 0: the caller's
    bool reproducible = false;  // the same pixels on every x86-64 CPU, for a third more time
    ContextKind context = ContextKind::automatic;  // kind of the OpenGL context
    bool wholeFrames = false;  // draw every frame as a whole; the pixels are the same
};

/// Texels per side of a picture's shadow map: 8/5 of its longer side, 512 to 4096. The map has a
/// quarter more.
int shadowTexels(const RendererSettings& settings);

/// The stages of drawing a picture, in this order.
enum class Stage { depth, occlusion, shadow, scene, readBack, resolve, overlay, done };

class Passes;

/// One per process and thread. The first one in a process decides `threads` and `reproducible`.
class Renderer {
public:
    /// Throws Error if there is no OpenGL 3.3 core context, or if the size is out of range.
    explicit Renderer(const RendererSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Throws Error if OpenGL reports an error or the first picture is all black. Where the
    /// frame is like the last one, the last picture is kept: frames of a film are best drawn in
    /// order.
    Image draw(const Frame& frame);

    /// The mean of 1 to 256 moments, earliest first. Each has another sample position in the pixel
    /// and on the lens, and other directions of the sun's and the sky's light. This gives motion
    /// blur, anti-aliasing, soft shadows, ambient occlusion and depth of field at once.
    /// Overlays are those of the last moment.
    Image draw(std::span<const Frame> moments);

    /// The surface at the centre of every pixel of the picture, the input of data_images.h. Throws
    /// Error if OpenGL reports an error.
    SurfaceMap surfaces(const Frame& frame);

    /// Calls `observer` when a stage begins and all earlier work is finished: for benchmarks.
    void observe(std::function<void(Stage)> observer);
    /// The share of the last picture that was drawn and not kept, 0..1; overlays are always drawn.
    double drawnShare() const;
    /// Renderer and version, as OpenGL reports them.
    std::string describe() const;

private:
    std::unique_ptr<Passes> passes_;
};

}  // namespace render
