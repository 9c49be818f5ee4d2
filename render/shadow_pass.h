/// The shadow map of a distant light, fitted to the frame's solids.
#pragma once
#include "render/meshes.h"

namespace render {

class ShadowPass {
public:
    /// `size`: texels per side.
    explicit ShadowPass(int size);
    /// `toLight`: of any length.
    void draw(const Frame& frame, const Vec3& toLight, const Meshes& meshes);

    GLuint map() const { return map_; }
    int size() const { return size_; }
    /// From the world (m) to texels, and to depths 0..1.
    Eigen::Matrix4f worldToTexels() const;
    float texel() const { return texel_; }  // m
    const Vec3& toLight() const { return toLight_; }
    /// The map's four corners, projected onto a plane along the light, in order around the middle;
    /// m. Empty if the light does not reach the plane from above.
    std::vector<Vec3> footprint(const Ground& ground) const;

private:
    void fit(const Frame& frame);

    int size_;
    GlTexture map_;
    GlFramebuffer framebuffer_;
    GlProgram program_;
    Eigen::Matrix4f worldToLight_ = Eigen::Matrix4f::Identity();  // m: x, y across, z to the light
    int used_[2] = {1, 1};                                        // texels of the map, in x and y
    Eigen::Vector2f half_{1, 1};                                  // m, half of what they cover
    float depth_ = 1.0f;                                          // m, half of what it covers
    float texel_ = 0.01f;
    Vec3 toLight_{0, 1, 0};
};

}  // namespace render
