#include "render/shadow_pass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
        const Eigen::Matrix3f axes = toLight * s.rotation.toRotationMatrix();
        const Vec3 reach =
            s.shape == SolidShape::sphere ? half : Vec3(axes.cwiseAbs() * half);
        const Vec3 middle = toLight * s.position;
        box.extend(Vec3(middle - reach - Vec3::Constant(core)));
        box.extend(Vec3(middle + reach + Vec3::Constant(core)));
    }
    for (const Rod& rod : frame.rods)
        for (const Vec3& end : {rod.from, rod.to}) {
            box.extend(Vec3(toLight * end - Vec3::Constant(rod.radius)));
            box.extend(Vec3(toLight * end + Vec3::Constant(rod.radius)));
        }
    if (box.isEmpty()) box.extend(Vec3(toLight * frame.camera.lookAt));
    return box;
}

/// Rounds up to the next quarter of an octave, so that the map's size rarely changes.
float inSteps(float length) {
    return std::exp2(std::ceil(std::log2(std::max(length, 0.5f)) * 4.0f) / 4.0f);
}

}  // namespace

int shadowTexels(const RendererSettings& settings) {
    if (settings.shadowSize > 0) return settings.shadowSize;
    const int wanted = 8 * std::max(settings.width, settings.height) / 5;
    return std::clamp((wanted + 255) / 256 * 256, 512, 4096);
}

ShadowPass::ShadowPass(int size)
    : size_(size),
      map_(newTexture(GL_DEPTH_COMPONENT16, size, size)),
      framebuffer_(newFramebuffer(0, map_)),
      program_(newProgram("depth", "depth")) {
    glBindTexture(GL_TEXTURE_2D, map_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

/// The middle is rounded to whole texels: the map does not move while the scene moves a little, and
/// neither do the steps at the shadows' edges.
void ShadowPass::fit(const Frame& frame) {
    worldToLight_ = lookAt(toLight_, Vec3::Zero(), Vec3::UnitY());
    worldToLight_.block<3, 1>(0, 3).setZero();
    const Eigen::AlignedBox3f box = boundsOf(frame, worldToLight_.block<3, 3>(0, 0));
    const Vec3 reach = 0.5f * box.sizes();
    const Vec3 covered(inSteps(reach.x()), inSteps(reach.y()), inSteps(reach.z()));
    const float widest = std::max(covered.x(), covered.y());
    texel_ = 2.0f * widest / (static_cast<float>(size_) - 2.0f * kApron);
    for (int i = 0; i < 2; ++i) {
        used_[i] = static_cast<int>(std::ceil(2.0f * covered[i] / texel_ + 2.0f * kApron));
        used_[i] = std::min(used_[i], size_);
        half_[i] = 0.5f * texel_ * static_cast<float>(used_[i]);
    }
    depth_ = covered.z() + widest;  // room for receivers a little beyond
    Vec3 middle = box.center();
    for (int i = 0; i < 2; ++i) middle[i] = std::floor(middle[i] / texel_) * texel_;
    worldToLight_.block<3, 1>(0, 3) = -middle;
}

Eigen::Matrix4f ShadowPass::worldToTexels() const {
    Eigen::Matrix4f toTexels = Eigen::Matrix4f::Identity();
    toTexels(0, 0) = toTexels(1, 1) = 1.0f / texel_;
    for (int i = 0; i < 2; ++i) toTexels(i, 3) = 0.5f * static_cast<float>(used_[i]);
    toTexels(2, 2) = -0.5f / depth_;
    toTexels(2, 3) = 0.5f;
    return toTexels * worldToLight_;
}

std::vector<Vec3> ShadowPass::footprint(const Ground& ground) const {
    const Vec3 normal = ground.normal.normalized();
    const float facing = normal.dot(toLight_);
    if (facing < 0.02f) return {};
    const Eigen::Matrix3f toWorld = worldToLight_.block<3, 3>(0, 0).transpose();
    const Vec3 shift = worldToLight_.block<3, 1>(0, 3);
    const Eigen::Vector2f inside = half_.array() - 2.0f * texel_;
    std::vector<Vec3> corners;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 local(static_cast<float>(x) * inside.x(), static_cast<float>(y) * inside.y(), 0);
        const Vec3 point = toWorld * (local - shift);
        corners.push_back(point + (ground.offset - normal.dot(point)) / facing * toLight_);
    }
    return corners;
}

void ShadowPass::draw(const Frame& frame, const Vec3& toLight, const Meshes& meshes) {
    toLight_ = toLight.normalized();
    fit(frame);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, used_[0], used_[1]);
    glClear(GL_DEPTH_BUFFER_BIT);
    Eigen::Matrix4f toClip = Eigen::Matrix4f::Identity();
    toClip(0, 0) = 1.0f / half_.x();
    toClip(1, 1) = 1.0f / half_.y();
    toClip(2, 2) = -1.0f / depth_;
    glCullFace(GL_FRONT);  // the picture's rows go down, the map's go up
    meshes.drawWith(program_, toClip * worldToLight_, Detail::fine);
    glCullFace(GL_BACK);
}

}  // namespace render
