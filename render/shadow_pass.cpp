#include "render/shadow_pass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/body_places.h"
#include "render/camera.h"
#include "render/renderer.h"

namespace render {
namespace {

constexpr float kTooLarge = 40.0f;  // m: with such a table or floor, a brick gets one texel
constexpr float kApron = 4.0f;      // texels kept free around the casters

/// Around the bodies that cast visible shadows, in the light's axes.
Eigen::AlignedBox3f boundsOf(const Frame& frame, const Eigen::Matrix3f& toLight) {
    Eigen::AlignedBox3f box;
    for (const Solid& s : frame.solids) {
        const float core = s.shape == SolidShape::capsule ? s.halfSize.x() : 0.0f;
        const Vec3 half = s.shape == SolidShape::capsule ? s.halfSize : holdingHalfSize(s);
        if (half.norm() + core > kTooLarge ||
            (s.position - frame.camera.lookAt).norm() > 4 * kTooLarge)
            continue;
        box.extend(lightBox(s, toLight));
    }
    for (const Rod& rod : frame.rods)
        for (const Vec3& end : {rod.from, rod.to}) {
            box.extend(Vec3(toLight * end - Vec3::Constant(rod.radius)));
            box.extend(Vec3(toLight * end + Vec3::Constant(rod.radius)));
        }
    if (box.isEmpty()) box.extend(Vec3(toLight * frame.camera.lookAt));
    return box;
}

/// Rounds up to the next of `steps` in an octave, so that the map's size rarely changes.
float inSteps(float length, float steps) {
    return std::exp2(std::ceil(std::log2(std::max(length, 0.5f)) * steps) / steps);
}

}  // namespace

int shadowTexels(const RendererSettings& settings) {
    if (settings.shadowSize > 0) return settings.shadowSize;
    const int wanted = 8 * std::max(settings.width, settings.height) / 5;
    return std::clamp((wanted + 255) / 256 * 256, 512, 4096);
}

Eigen::AlignedBox3f lightBox(const Solid& solid, const Eigen::Matrix3f& toLight) {
    const bool capsule = solid.shape == SolidShape::capsule;
    const float core = capsule ? solid.halfSize.x() : 0.0f;
    const Vec3 half = capsule ? solid.halfSize : holdingHalfSize(solid);
    const Eigen::Matrix3f axes = toLight * solid.rotation.toRotationMatrix();
    const Vec3 reach = solid.shape == SolidShape::sphere ? half : Vec3(axes.cwiseAbs() * half);
    const Vec3 middle = toLight * solid.position;
    return {Vec3(middle - reach - Vec3::Constant(core)),
            Vec3(middle + reach + Vec3::Constant(core))};
}

Eigen::Matrix4f ShadowFit::worldToTexels() const {
    Eigen::Matrix4f toTexels = Eigen::Matrix4f::Identity();
    toTexels(0, 0) = toTexels(1, 1) = 1.0f / texel;
    for (int i = 0; i < 2; ++i) toTexels(i, 3) = 0.5f * static_cast<float>(used[i]);
    toTexels(2, 2) = -0.5f / depth;
    toTexels(2, 3) = 0.5f;
    return toTexels * worldToLight;
}

bool ShadowFit::operator==(const ShadowFit& other) const {
    return toLight == other.toLight && worldToLight == other.worldToLight &&
           used[0] == other.used[0] && used[1] == other.used[1] && half == other.half &&
           depth == other.depth && texel == other.texel;
}

ShadowPass::ShadowPass(int size)
    : size_(size),
      texels_(size + 2 * (size / 8 + 2)),
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

/// The map covers more than it needs, and its middle moves by a quarter of its size at a time, in
/// whole texels: it stands still while the scene moves a little, and so do the steps at the
/// shadows' edges.
ShadowFit ShadowPass::fitTo(const Frame& frame, const Vec3& toLight) const {
    ShadowFit fit;
    fit.size = texels_;
    fit.toLight = toLight.normalized();
    fit.worldToLight = lookAt(fit.toLight, Vec3::Zero(), Vec3::UnitY());
    fit.worldToLight.block<3, 1>(0, 3).setZero();
    const Eigen::AlignedBox3f box = boundsOf(frame, fit.worldToLight.block<3, 3>(0, 0));
    const Vec3 reach = 0.5f * box.sizes();
    const float widest = inSteps(std::max(reach.x(), reach.y()), 4.0f);
    fit.texel = 2.0f * widest / (static_cast<float>(size_) - 2.0f * kApron);
    Vec3 middle = box.center();
    const int room = size_ / 8;  // texels on each side
    for (int i = 0; i < 2; ++i) {
        const float covered = 2.0f * inSteps(reach[i], 4.0f) / fit.texel + 2.0f * kApron;
        const int needed = std::min(static_cast<int>(std::ceil(covered)), size_);
        fit.used[i] = needed + 2 * (room + 1);  // odd: the middle is that of a texel
        fit.half[i] = 0.5f * fit.texel * static_cast<float>(fit.used[i]);
        const float step = static_cast<float>(2 * room);
        middle[i] = fit.texel * (std::floor(middle[i] / (step * fit.texel)) * step +
                                 static_cast<float>(room));
    }
    const float step = inSteps(reach.z(), 1.0f) + widest;
    fit.depth = 1.5f * step;  // also room for receivers a little beyond
    middle.z() = (std::floor(middle.z() / step) + 0.5f) * step;
    fit.worldToLight.block<3, 1>(0, 3) = -middle;
    return fit;
}

std::vector<Vec3> ShadowPass::footprint(const Ground& ground) const {
    const Vec3 normal = ground.normal.normalized();
    const float facing = normal.dot(fit_.toLight);
    if (facing < 0.02f) return {};
    const Eigen::Matrix3f toWorld = fit_.worldToLight.block<3, 3>(0, 0).transpose();
    const Vec3 shift = fit_.worldToLight.block<3, 1>(0, 3);
    const Eigen::Vector2f inside = fit_.half.array() - 2.0f * fit_.texel;
    std::vector<Vec3> corners;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 local(static_cast<float>(x) * inside.x(), static_cast<float>(y) * inside.y(), 0);
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
    glViewport(0, 0, fit_.used[0], fit_.used[1]);
    Eigen::Matrix4f toClip = Eigen::Matrix4f::Identity();
    toClip(0, 0) = 1.0f / fit_.half.x();
    toClip(1, 1) = 1.0f / fit_.half.y();
    toClip(2, 2) = -1.0f / fit_.depth;
    glCullFace(GL_FRONT);  // the picture's rows go down, the map's go up
    meshes.drawWith(program_, toClip * fit_.worldToLight, Detail::fine, Half::lit);
    glCullFace(GL_BACK);
}

}  // namespace render
