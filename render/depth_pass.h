/// Depths at half the picture's size, without colour: for ambient occlusion, and for overlays that
/// bodies may hide.
#pragma once
#include "render/empty_tiles.h"
#include "render/ground_mesh.h"
#include "render/meshes.h"
#include "render/occlusion.h"

namespace render {

class DepthPass {
public:
    DepthPass(int width, int height);
    /// Into `map`.
    void draw(const Frame& frame, const View& view, const Meshes& meshes, const GroundMesh& ground,
              DepthMap& map) const;
    /// Draws these tiles again over what draw() left; the meshes may lack what is not in them. The
    /// rectangle around them is read into `map`, which has the size of the last one.
    void drawPart(const TileSet& tiles, const Frame& frame, const View& view,
                  const Meshes& meshes, const GroundMesh& ground, DepthMap& map) const;
    int width() const { return width_; }    // pixels of the map
    int height() const { return height_; }  // pixels of the map

private:
    void drawBodies(const Frame& frame, const View& view, const Meshes& meshes,
                    const GroundMesh& ground) const;
    void read(const PixelRect& part, const View& view, DepthMap& map) const;

    int width_, height_;
    GlTexture depth_;
    GlFramebuffer framebuffer_;
    GlProgram solid_, ground_;
    EmptyTiles empty_;
};

}  // namespace render
