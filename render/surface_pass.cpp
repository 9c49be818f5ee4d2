#include "render/surface_pass.h"

namespace render {

SurfacePass::SurfacePass(int width, int height)
    : width_(width),
      height_(height),
      number_(newRenderbuffer(GL_R32I, width, height)),
      depth_(newRenderbuffer(GL_DEPTH_COMPONENT32F, width, height)),
      framebuffer_(newFramebuffer(0, 0, number_, depth_)),
      solid_(newProgram("surface", "surface")),
      ground_(newProgram("ground", "surface_ground")) {}

SurfaceMap SurfacePass::draw(const Frame& frame, const View& view, const Meshes& meshes,
                             const GroundMesh& ground) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    const GLint nothing[] = {kNoSurface, 0, 0, 0};
    glClearBufferiv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    meshes.drawWith(solid_, view.worldToClip(), Detail::fine, Half::seen);
    meshes.drawWith(solid_, view.worldToClip(), Detail::fine, Half::seen, Material::glass);
    glUseProgram(ground_);
    setUniform(ground_, "worldToClip", view.worldToClip());
    for (std::size_t i = 0; i < frame.grounds.size(); ++i) {
        if (!frame.grounds[i].visible) continue;
        setUniform(ground_, "surface", packedSurface(surfaceOfGround(frame, i), 0));
        ground.draw(groundCorners(frame.grounds[i], view, {}).around);
    }

    SurfaceMap map{width_, height_, {}};
    map.packed.resize(static_cast<std::size_t>(width_) * height_);
    glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_INT, map.packed.data());
    return map;
}

}  // namespace render
