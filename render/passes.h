/// All that a renderer holds: the context, the passes, and how a picture goes through them.
#pragma once
#include <functional>
#include <memory>

#include "render/context.h"
#include "render/renderer.h"
#include "render/sampling.h"
#include "render/scene_pass.h"
#include "render/surface_pass.h"

namespace render {

/// In the order of drawing; the context first, so that everything else is freed before it.
class Passes {
public:
    explicit Passes(const RendererSettings& settings);

    /// The bodies, their ground and the sky. `depth`: filled where overlays need it.
    Image drawScene(const Frame& frame, DepthMap& depth);
    /// One sub-frame, without a depth of its own.
    Image drawSample(const Frame& frame, const SubSample& sample);
    /// Depths of a frame, for what is drawn over it.
    DepthMap drawDepth(const Frame& frame);
    SurfaceMap drawSurfaces(const Frame& frame);

    View viewOf(const Frame& frame) const;
    View sampleView(const Frame& frame, const SubSample& sample) const;
    void enter(Stage stage) const;
    const RendererSettings& settings() const { return settings_; }
    std::string describe() const { return context_->describe(); }

    std::function<void(Stage)> observer;

private:
    void setMeshes(const Frame& frame, const View& view);
    OcclusionSettings occlusionOf(const Frame& frame, const View& view, const DepthMap& map) const;
    /// `where`: of the half-size map, the rest of which is full.
    void darken(const ByteMap& halfSize, const std::vector<PixelRect>& where, Lights& lights);
    Image readBack() const;
    Image finished(Image image, const Look& look) const;

    RendererSettings settings_;
    std::unique_ptr<Context> context_;
    Meshes meshes_;
    GroundMesh ground_;
    ShadowPass sun_;
    DepthPass depth_;
    GlTexture openMap_;
    ScenePass scene_;
    std::unique_ptr<SurfacePass> surfaces_;  // made when first asked for
};

}  // namespace render
