#include "render/shadow_pass.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace render {
namespace {

constexpr float kTooLarge = 40.0f;  // m: a table or floor that would leave a texel for a brick

struct Sphere {
    Vec3 centre{0, 0, 0};
    float radius = 1.0f;
};

/// Around what casts shadows worth seeing.
Sphere boundsOf(const Frame& frame) {
    Vec3 low = Vec3::Constant(1e9f), high = Vec3::Constant(-1e9f);
    for (const Solid& s : frame.solids) {
        const float reach = s.halfSize.norm() + (s.shape == SolidShape::capsule ? s.halfSize.x() : 0);
        if (reach > kTooLarge || (s.position - frame.camera.lookAt).norm() > 4 * kTooLarge) continue;
        low = low.cwiseMin(s.position - Vec3::Constant(reach));
        high = high.cwiseMax(s.position + Vec3::Constant(reach));
    }
    if (low.x() > high.x()) return {frame.camera.lookAt, 5.0f};
    return {0.5f * (low + high), 0.5f * (high - low).norm()};
}

}  // namespace

ShadowPass::ShadowPass(int size)
    : size_(size),
      map_(newTexture(GL_DEPTH_COMPONENT24, size, size)),
      framebuffer_(newFramebuffer(0, map_)),
      program_(newProgram("shadow", "shadow")) {
    glBindTexture(GL_TEXTURE_2D, map_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void ShadowPass::fit(const Frame& frame) {
    const Sphere sphere = boundsOf(frame);
    // The radius in steps and the middle in texels: the map stands still while the scene moves a
    // little, and so do the stairs at the shadows' edges.
    const float radius = std::exp2(std::ceil(std::log2(std::max(sphere.radius, 0.5f)) * 4.0f) / 4.0f);
    texel_ = 2.0f * radius / static_cast<float>(size_);
    toSun_ = frame.look.sunDirection.normalized();
    Eigen::Matrix4f view = lookAt(toSun_, Vec3::Zero(), Vec3::UnitY());
    view.block<3, 1>(0, 3).setZero();
    Vec3 middle = view.block<3, 3>(0, 0) * sphere.centre;
    for (int i = 0; i < 2; ++i) middle[i] = std::floor(middle[i] / texel_) * texel_;
    view.block<3, 1>(0, 3) = -middle;
    Eigen::Matrix4f projection = Eigen::Matrix4f::Identity();
    const float depth = 3.0f * radius;
    projection(0, 0) = projection(1, 1) = 1.0f / radius;
    projection(2, 2) = -1.0f / depth;
    worldToShadow_ = projection * view;
}

void ShadowPass::draw(const Frame& frame, const InstancedMesh& boxes, const InstancedMesh& balls,
                      const InstancedMesh& bars) {
    fit(frame);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size_, size_);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (!frame.look.shadows) return;
    glUseProgram(program_);
    setUniform(program_, "worldToShadow", worldToShadow_);
    for (const InstancedMesh* mesh : {&boxes, &balls, &bars}) mesh->draw();
}

}  // namespace render
