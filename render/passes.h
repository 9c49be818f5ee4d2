/// The implementation of a renderer: the context, and the passes that make a picture.
#pragma once
#include <functional>
#include <memory>

#include "render/context.h"
#include "render/renderer.h"
#include "render/sampling.h"
#include "render/scene_pass.h"
#include "render/surface_pass.h"

namespace render {

/// Members are in the order of drawing; the context is first, so that it is destroyed last.
class Passes {
public:
    explicit Passes(const RendererSettings& settings);

    /// Draws the bodies, their ground and the sky. `depth`: filled if overlays need it.
    Image drawScene(const Frame& frame, DepthMap& depth);
    /// Draws one sub-frame, without returning depths.
    Image drawSample(const Frame& frame, const SubSample& sample);
    /// The depths of a frame, for its overlays.
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
    /// `where`: parts of the half-size map; the rest is 255.
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
    std::unique_ptr<SurfacePass> surfaces_;  // made when first needed
};

}  // namespace render
