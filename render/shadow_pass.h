/// What the sun sees, as depths: one map fitted to the frame's solids.
#pragma once
#include "render/meshes.h"

namespace render {

class ShadowPass {
public:
    explicit ShadowPass(int size);
    void draw(const Frame& frame, const InstancedMesh& boxes, const InstancedMesh& balls,
              const InstancedMesh& bars);

    GLuint map() const { return map_; }
    const Eigen::Matrix4f& worldToShadow() const { return worldToShadow_; }
    float texel() const { return texel_; }  // m
    const Vec3& toSun() const { return toSun_; }

private:
    void fit(const Frame& frame);

    int size_;
    GlTexture map_;
    GlFramebuffer framebuffer_;
    GlProgram program_;
    Eigen::Matrix4f worldToShadow_ = Eigen::Matrix4f::Identity();
    float texel_ = 0.01f;
    Vec3 toSun_{0, 1, 0};
};

}  // namespace render
