#include "render/renderer.h"

#include <utility>

#include "render/accumulator.h"
#include "render/overlay.h"
#include "render/passes.h"

namespace render {
namespace {

constexpr std::size_t kMostMoments = 256;

/// Draws the overlays on the finished picture.
void drawOver(Image& image, const Frame& frame, const DepthMap& depth, Passes& passes) {
    passes.enter(Stage::overlay);
    const View view = passes.viewOf(frame);
    const SurfaceMap nothing;
    const SurfaceMap& surfaces = frame.ghosts.empty() ? nothing : passes.opaqueSurfaces(frame);
    drawOverlays(image, frame, view, {depth, surfaces});
    passes.enter(Stage::done);
}

}  // namespace

Renderer::Renderer(const RendererSettings& settings)
    : passes_(std::make_unique<Passes>(settings)) {}
Renderer::~Renderer() = default;

std::string Renderer::describe() const { return passes_->describe(); }

void Renderer::observe(std::function<void(Stage)> observer) {
    passes_->observer = std::move(observer);
}

Image Renderer::draw(const Frame& frame) {
    Image image = passes_->drawScene(frame);
    drawOver(image, frame, passes_->depths(), *passes_);
    return image;
}

Image Renderer::draw(std::span<const Frame> moments) {
    if (moments.empty() || moments.size() > kMostMoments)
        throw Error("cannot draw a picture of " + std::to_string(moments.size()) +
                    " moments: 1 to 256 are allowed");
    const Vec3& sun = moments.back().look.sunDirection;
    const int count = static_cast<int>(moments.size());
    Accumulator sum(passes_->settings().width, passes_->settings().height);
    for (int i = 0; i < count; ++i) {
        const Image image = passes_->drawSample(moments[i], subSample(i, count, sun));
        passes_->enter(Stage::resolve);
        sum.add(image);
    }
    Image image = sum.mean();
    const Frame& now = moments.back();
    drawOver(image, now, needsDepth(now) ? passes_->drawDepth(now) : DepthMap{}, *passes_);
    return image;
}

double Renderer::drawnShare() const { return passes_->drawnShare(); }

SurfaceMap Renderer::surfaces(const Frame& frame) { return passes_->drawSurfaces(frame); }

}  // namespace render
