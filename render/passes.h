/// The implementation of a renderer: the context, and the passes that make a picture.
#pragma once
#include <functional>
#include <memory>

#include "render/changed_region.h"
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

    /// Draws the bodies, their ground and the sky; keeps of the last picture what does not change,
    /// unless `wholeFrames` is set.
    Image drawScene(const Frame& frame);
    /// The depths of the last scene, if overlays need them.
    const DepthMap& depths() const { return kept_.depth; }
    /// 0..1 of the picture that the last drawing did not keep.
    double drawnShare() const { return drawnShare_; }
    /// Draws one sub-frame, without returning depths.
    Image drawSample(const Frame& frame, const SubSample& sample);
    /// The depths of a frame, for its overlays.
    DepthMap drawDepth(const Frame& frame);
    SurfaceMap drawSurfaces(const Frame& frame) { return drawSurfaces(frame, nullptr); }
    /// The surfaces of a frame without its glass, for its ghosts. To be called after drawScene() of this
    /// frame or drawSample().
    const SurfaceMap& opaqueSurfaces(const Frame& frame);

    View viewOf(const Frame& frame) const;
    View sampleView(const Frame& frame, const SubSample& sample) const;
    void enter(Stage stage) const;
    const RendererSettings& settings() const { return settings_; }
    std::string describe() const { return context_->describe(); }

    std::function<void(Stage)> observer;

private:
    /// The picture of the last frame, and what it was made from.
    struct Kept {
        bool valid = false;
        Frame frame;
        bool deep = false;  // `depth` is of this frame
        DepthMap depth;
        KeptOpenness openness;
        PixelRect darkened;
        ShadowFit sun;
        Image image;          // one sample per pixel
        SurfaceMap surfaces;  // with joined faces
        Image smooth;
    };
    /// What is drawn of a frame.
    struct Part {
        bool comparable = false;  // with the last one: view and light are the same
        bool whole = true;
        TileSet bodies;    // that moved, in the picture
        TileSet tiles;     // of the picture, unless it is drawn as a whole
        TileSet texels;    // of the shadow map, unless it is drawn as a whole
    };

    /// `chosen`: as in instancesOf().
    void setMeshes(const Frame& frame, const View& view, const std::vector<char>* chosen = nullptr) {
        setMeshes(frame, view, frame.look.sunDirection, chosen);
    }
    void setMeshes(const Frame& frame, const View& view, const Vec3& toSun,
                   const std::vector<char>* chosen = nullptr);
    SurfaceMap drawSurfaces(const Frame& frame, const std::vector<char>* chosen);
    void setMeshesIn(const TileSet& tiles, const Frame& frame, const View& view);
    Part partOf(const Frame& frame, const View& view, const ShadowFit* sun);
    TileSet renewDepths(const Frame& frame, const View& view, const Part& part);
    void renewOpenness(const Frame& frame, const View& view, const TileSet& changed, Part& part,
                       Lights& lights);
    void drawShadows(const Frame& frame, const View& view, const ShadowFit& fit);
    void renewShadows(const Frame& frame, const View& view, const ShadowFit& fit, const Part& part);
    void renewPicture(const Frame& frame, const View& view, const Lights& lights, const Part& part);
    OcclusionSettings occlusionOf(const Frame& frame, const View& view, const DepthMap& map) const;
    void uploadOpenness(const ByteMap& halfSize, const PixelRect& where);
    bool isFull() const { return settings_.finish == Finish::standard; }
    bool isSmooth() const { return isFull() && settings_.samples > 1; }
    PixelRect all() const { return {0, 0, settings_.width, settings_.height}; }
    Image finished(Image image, const Look& look);

    RendererSettings settings_;
    std::unique_ptr<Context> context_;
    Meshes meshes_;
    GroundMesh ground_;
    ShadowPass sun_;
    DepthPass depth_;
    GlTexture openMap_;
    ScenePass scene_;
    std::unique_ptr<SurfacePass> surfaces_;  // made when first needed
    Kept kept_;
    SurfaceMap opaque_;  // where those of `kept_` do not serve
    DepthMap spare_;     // its memory is used again
    double drawnShare_ = 1.0;
    bool drawsSomething_ = false;  // a picture was not all black: the driver draws
};

}  // namespace render
