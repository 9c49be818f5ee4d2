#include "render/depth_pass.h"

#include <algorithm>

namespace render {

DepthPass::DepthPass(int width, int height)
    : width_(std::max(width / 2, 1)),
      height_(std::max(height / 2, 1)),
      depth_(newTexture(GL_DEPTH_COMPONENT32F, width_, height_)),
      framebuffer_(newFramebuffer(0, depth_)),
      solid_(newProgram("depth", "depth")),
      ground_(newProgram("ground", "depth")) {}

DepthMap DepthPass::draw(const Frame& frame, const View& view, const Meshes& meshes,
                         const GroundMesh& ground) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    glClear(GL_DEPTH_BUFFER_BIT);
    meshes.drawWith(solid_, view.worldToClip(), Detail::coarse);
    glUseProgram(ground_);
    setUniform(ground_, "worldToClip", view.worldToClip());
    for (const Ground& plane : frame.grounds)
        if (plane.visible) ground.draw(groundCorners(plane, view, {}).around);

    DepthMap map{width_, height_, {}};
    map.meters.resize(static_cast<std::size_t>(width_) * height_);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, map.meters.data());
    // The depth in m from the stored value: 1 / m = a + b stored.
    const float a = 1.0f / view.nearest, b = 1.0f / view.farthest - a;
    for (float& depth : map.meters) depth = 1.0f / (a + b * depth);
    return map;
}

}  // namespace render
