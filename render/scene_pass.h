/// Draws the picture itself: solids, rods, grounds, sky and trails, with one sample per pixel.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "render/depth_pass.h"
#include "render/image.h"
#include "render/mirror_pass.h"
#include "render/shadow_pass.h"
#include "render/surface_map.h"
#include "render/tile_set.h"

namespace render {

/// The light of a picture.
struct Lights {
    const ShadowPass* sun = nullptr;  // null: nothing casts shadows
    bool corners = false;             // light per vertex only: for drafts
    GLuint openMap = 0;               // visible share of the sky; 0: all of it everywhere
    PixelRect darkened;               // where openMap may be below its maximum
    PixelRect shaded;                 // where a ground may be in a shadow
};

class ScenePass {
public:
    ScenePass(int width, int height);
    /// `numbered`: also stores the surface at every pixel. `only`: the tiles to draw; the others are
    /// kept, and the meshes may lack what is not in these; null: all.
    void draw(const Frame& frame, const View& view, const Lights& lights, bool numbered,
              const Meshes& meshes, const GroundMesh& ground, const TileSet* only = nullptr);

    /// Reads a part of the picture into an image of its size.
    void read(const PixelRect& part, Image& image) const;
    void read(const PixelRect& part, SurfaceMap& map) const;

private:
    /// The arguments of draw() that all its parts need.
    struct Scene {
        const Frame& frame;
        const View& view;
        Lights lights;
        std::optional<std::size_t> floor{};  // the ground whose image of the bodies this is
        bool glossy = false;                 // its image is in the part that is drawn
    };
    void keepAllButDrawn();
    bool scissor(const PixelRect& rect) const;
    GLuint lit(const std::string& vertex, const std::string& fragment, const std::string& features,
               const Scene& scene);
    void drawBodies(const Scene& scene, const Meshes& meshes, Material material);
    void drawMirrored(const Scene& scene, const Meshes& meshes);
    void drawGlass(const Scene& scene, const Meshes& meshes);
    void drawBackground(const Scene& scene, const GroundMesh& mesh);
    void drawGrounds(const Scene& scene, const GroundMesh& mesh, const PixelRect& part);
    void drawGround(const Scene& scene, const GroundMesh& mesh, std::size_t number, const PixelRect& part);
    void setGround(const Scene& scene, std::size_t number, const GroundCorners& corners,
                   const std::string& features);
    void setMirror(GLuint program, const Scene& scene, std::size_t floor,
                   const GroundCorners& corners);
    void drawSky(const Scene& scene);
    void drawTrails(const Scene& scene);

    int width_, height_;
    GlRenderbuffer color_, number_, depth_;
    GlFramebuffer framebuffer_;
    std::map<std::string, GlProgram> programs_;  // by fragment shader and features, made when used
    GlProgram trail_;
    std::vector<PixelRect> drawn_;  // the parts that are drawn
    std::vector<PixelRect> open_;   // the parts where something can be drawn: of other depth than 0
    GlArray empty_, trailArray_;
    GlBuffer trailBuffer_;
    EmptyTiles tiles_;
    std::unique_ptr<MirrorPass> mirror_;  // made when first needed
    std::optional<std::size_t> mirrored_;  // the ground that shows its picture
    PixelRect imageRect_;                  // where it shows it
};

}  // namespace render
