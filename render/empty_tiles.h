/// Rectangles that are made empty: without a body, at the largest depth.
#pragma once
#include <vector>

#include "render/ground_mesh.h"
#include "render/pixel_rect.h"

namespace render {

class EmptyTiles {
public:
    EmptyTiles() : program_(newProgram("tile", "tile")) {}
    /// In the framebuffer that is bound, of this size; row 0 is its first. `depth`: from 0, where
    /// nothing can be drawn, to 1, the largest.
    void draw(const std::vector<PixelRect>& rects, int width, int height,
              float depth = 1.0f) const;

private:
    GlProgram program_;
    GroundMesh mesh_;
};

/// Reads a rectangle from the framebuffer that is bound to its place in an array with rows of
/// `width` pixels.
void readPart(const PixelRect& part, int width, GLenum format, GLenum type, void* pixels);

}  // namespace render
