#include "render/shadow_pass.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "render/body_places.h"
#include "render/renderer.h"

namespace render {

int shadowTexels(const RendererSettings& settings) {
    if (settings.shadowSize > 0) return settings.shadowSize;
    const int wanted = 8 * std::max(settings.width, settings.height) / 5;
    return std::clamp((wanted + 255) / 256 * 256, 512, 4096);
}

ShadowPass::ShadowPass(int size)
    : texels_(size + 2 * (size / 8 + 2)),
      map_(newTexture(GL_DEPTH_COMPONENT16, texels_, texels_)),
      framebuffer_(newFramebuffer(0, map_)),
      program_(newProgram("depth", "depth")) {
    glBindTexture(GL_TEXTURE_2D, map_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glClear(GL_DEPTH_BUFFER_BIT);
    fit_.size = texels_;
    covered_ = texelTiles(fit_);
}

std::vector<Vec3> ShadowPass::footprint(const Ground& ground) const {
    const Vec3 normal = ground.normal.normalized();
    const float facing = normal.dot(fit_.toLight);
    if (facing < 0.02f) return {};
    const Eigen::Matrix3f toWorld = fit_.worldToLight.block<3, 3>(0, 0).transpose();
    const Vec3 shift = fit_.worldToLight.block<3, 1>(0, 3);
    const float inside = fit_.half() - 2.0f * fit_.texel;
    std::vector<Vec3> corners;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 local(static_cast<float>(x) * inside, static_cast<float>(y) * inside, 0);
        const Vec3 point = toWorld * (local - shift);
        corners.push_back(point + (ground.offset - normal.dot(point)) / facing * fit_.toLight);
    }
    return corners;
}

/// Only what the last drawing covered has to be cleared.
void ShadowPass::draw(const ShadowFit& fit, const Meshes& meshes, const TileSet& covered) {
    fit_ = fit;
    drawOver(meshes, covered_);
    covered_ = covered;
}

void ShadowPass::drawPart(const Meshes& meshes, const TileSet& tiles) {
    const std::vector<PixelRect> rects = tiles.rects();
    if (rects.empty()) return;
    const PixelRect part = render::boundsOf(rects);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x0, part.y0, part.x1 - part.x0, part.y1 - part.y0);
    drawOver(meshes, tiles);
    glDisable(GL_SCISSOR_TEST);
    covered_.add(tiles);
}

/// What is drawn again beside the tiles is not nearer than what is there.
void ShadowPass::drawOver(const Meshes& meshes, const TileSet& tiles) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, texels_, texels_);
    empty_.draw(tiles.rects(), texels_, texels_);
    glViewport(1, 1, texels_ - 2, texels_ - 2);
    Eigen::Matrix4f toClip = Eigen::Matrix4f::Identity();
    toClip(0, 0) = 1.0f / fit_.half();
    toClip(1, 1) = 1.0f / fit_.half();
    toClip(2, 2) = -1.0f / fit_.depth;
    glCullFace(GL_FRONT);  // the picture's rows go down, the map's go up
    meshes.drawWith(program_, toClip * fit_.worldToLight, Detail::fine, Half::lit);
    glCullFace(GL_BACK);
}

}  // namespace render
