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

/// How much trouble is taken with a picture.
enum class Finish {
    draft,    // one sample a pixel, light at corners, no shadows: to see whether the scene is right
    standard  // shadows, ambient occlusion, `samples` a pixel where there are edges
};

/// What a Renderer is made with.
struct RendererSettings {
    int width = 1280, height = 720;  // pixels, 1..16384
    int samples = 8;                 // of a pixel with an edge: 1, 2, 4, 8 or 16; 1: edges in steps
    int shadowSize = 0;              // texels a side of a shadow map; 0: by the picture's size
    Finish finish = Finish::standard;
    int threads = -1;           // of the rasteriser; -1: as many as it likes, 0: the caller's
    bool reproducible = false;  // the same pixels on every x86-64 CPU, for a third more time
    ContextKind context = ContextKind::automatic;  // what OpenGL is reached through
};

/// Texels a side of the shadow map of a picture: a fifth more than it has pixels, 512 to 4096.
int shadowTexels(const RendererSettings& settings);

/// What a picture's time goes to, in this order.
enum class Stage { depth, occlusion, shadow, scene, readBack, resolve, overlay, done };

class Passes;

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

    /// The mean of 1 to 256 moments, earliest first, each seen from another place in the pixel and
    /// on the lens, with the sun and the sky's light from another direction: motion blur,
    /// anti-aliasing, soft shadows, ambient occlusion and depth of field for the price of samples.
    /// What is drawn over the picture is that of the last moment.
    Image draw(std::span<const Frame> moments);

    /// Which surface is at the centre of every pixel of the picture (data_images.h goes on from
    /// there). Throws Error when OpenGL reports an error.
    SurfaceMap surfaces(const Frame& frame);

    /// Calls `observer` when a stage begins, with everything before it finished: for benchmarks.
    void observe(std::function<void(Stage)> observer);
    /// Renderer and version, as OpenGL names them.
    std::string describe() const;

private:
    std::unique_ptr<Passes> passes_;
};

}  // namespace render
