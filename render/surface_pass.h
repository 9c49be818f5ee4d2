/// Finds the surface seen at the centre of every pixel, with one sample per pixel: the numbers of
/// two surfaces have no mean. The driver decides which surface is seen; its depth, normal and flow
/// are then computed in closed form in C++ (data_images.h).
#pragma once
#include "render/ground_mesh.h"
#include "render/meshes.h"
#include "render/surface_map.h"

namespace render {

class SurfacePass {
public:
    SurfacePass(int width, int height);
    /// `view`: upside down, so that the first row read back is the top one.
    SurfaceMap draw(const Frame& frame, const View& view, const Meshes& meshes,
                    const GroundMesh& ground) const;

private:
    int width_, height_;
    GlRenderbuffer number_, depth_;
    GlFramebuffer framebuffer_;
    GlProgram solid_, ground_;
};

}  // namespace render
