/// The shadow map of a distant light, fitted to the frame's solids.
#pragma once
#include <vector>

#include "render/empty_tiles.h"
#include "render/meshes.h"
#include "render/shadow_fit.h"
#include "render/tile_set.h"

namespace render {

class ShadowPass {
public:
    /// `size`: shadowTexels(); the map has a quarter more.
    explicit ShadowPass(int size);
    /// `covered`: texelTiles() where anything is drawn.
    void draw(const ShadowFit& fit, const Meshes& meshes, const TileSet& covered);
    /// Draws these tiles again, with the fit of the last drawing; the others are kept. The meshes may
    /// lack what is not there.
    void drawPart(const Meshes& meshes, const TileSet& tiles);

    GLuint map() const { return map_; }
    int size() const { return texels_; }  // per side
    const ShadowFit& fit() const { return fit_; }  // of the last drawing
    /// The map's four corners, projected onto a plane along the light, in order around the middle;
    /// m. Empty if the light does not reach the plane from above.
    std::vector<Vec3> footprint(const Ground& ground) const;

private:
    void drawOver(const Meshes& meshes, const TileSet& tiles);

    int texels_;  // per side of the map
    GlTexture map_;
    GlFramebuffer framebuffer_;
    GlProgram program_;
    ShadowFit fit_;
    TileSet covered_;  // all other tiles are empty
    EmptyTiles empty_;
};

}  // namespace render
