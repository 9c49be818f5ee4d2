/// Depths at half the picture's size, without colour: for ambient occlusion, and for overlays that
/// bodies may hide.
#pragma once
#include "render/ground_mesh.h"
#include "render/meshes.h"
#include "render/occlusion.h"

namespace render {

class DepthPass {
public:
    DepthPass(int width, int height);
    DepthMap draw(const Frame& frame, const View& view, const Meshes& meshes,
                  const GroundMesh& ground) const;

private:
    int width_, height_;
    GlTexture depth_;
    GlFramebuffer framebuffer_;
    GlProgram solid_, ground_;
};

}  // namespace render
