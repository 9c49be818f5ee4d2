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

void DepthPass::draw(const Frame& frame, const View& view, const Meshes& meshes,
                     const GroundMesh& ground, DepthMap& map) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBodies(frame, view, meshes, ground);
    map.width = width_, map.height = height_;
    map.meters.resize(static_cast<std::size_t>(width_) * height_);
    read({0, 0, width_, height_}, view, map);
}

/// What is drawn again beside the tiles is not nearer than what is there.
void DepthPass::drawPart(const TileSet& tiles, const Frame& frame, const View& view,
                         const Meshes& meshes, const GroundMesh& ground, DepthMap& map) const {
    const std::vector<PixelRect> rects = tiles.rects();
    if (rects.empty()) return;
    const PixelRect part = boundsOf(rects);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    empty_.draw(rects, width_, height_);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x0, part.y0, part.x1 - part.x0, part.y1 - part.y0);
    drawBodies(frame, view, meshes, ground);
    glDisable(GL_SCISSOR_TEST);
    read(part, view, map);
}

void DepthPass::drawBodies(const Frame& frame, const View& view, const Meshes& meshes,
                           const GroundMesh& ground) const {
    meshes.drawWith(solid_, view.worldToClip(), Detail::coarse, Half::seen);
    glUseProgram(ground_);
    setUniform(ground_, "worldToClip", view.worldToClip());
    for (const Ground& plane : frame.grounds)
        if (plane.visible) ground.draw(groundCorners(plane, view, {}).around);
}

void DepthPass::read(const PixelRect& part, const View& view, DepthMap& map) const {
    readPart(part, width_, GL_DEPTH_COMPONENT, GL_FLOAT, map.meters.data());
    // The depth in m from the stored value: 1 / m = a + b stored.
    const float a = 1.0f / view.nearest, b = 1.0f / view.farthest - a;
    for (int y = part.y0; y < part.y1; ++y) {
        float* row = &map.meters[static_cast<std::size_t>(y) * width_];
        for (int x = part.x0; x < part.x1; ++x) row[x] = 1.0f / (a + b * row[x]);
    }
}

}  // namespace render
