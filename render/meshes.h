/// Box, ball and bar as triangles, and the instances of a frame that are drawn with them.
#pragma once
#include <array>
#include <vector>

#include "render/gl.h"

namespace render {

/// A corner: position on the unit shape, normal, and which end of a stretched shape it belongs to.
struct Vertex {
    Vec3 position, normal;
    float end;  // -1, 0, 1: moved by the instance's `stretch` along its y
};

/// world = position + rotation * (vertex.position * scale + (0, end * stretch, 0))
struct Instance {
    Vec3 position;
    Eigen::Vector4f rotation;  // quaternion x, y, z, w
    Vec3 scale;                // m
    float stretch;             // m
    Vec3 color;                // linear
    float surface;             // its number (surface_map.h); whole, below 2^24
};

std::vector<Vertex> boxMesh();
/// Of so many corners around; a multiple of 4.
std::vector<Vertex> ballMesh(int corners);
std::vector<Vertex> barMesh();

/// One mesh, drawn many times in one call.
class InstancedMesh {
public:
    explicit InstancedMesh(const std::vector<Vertex>& mesh);
    void setInstances(const std::vector<Instance>& instances);
    void draw() const;

private:
    GlArray array_;
    GlBuffer vertices_, instances_;
    int vertexCount_ = 0, instanceCount_ = 0;
};

/// A ball's corners around, from small pictures of it to large ones: a third of a pixel off.
inline constexpr std::array<int, 4> kBallCorners = {16, 28, 44, 64};

/// Solids and rods of a frame, by mesh, nearest first: what is hidden is not shaded.
struct Instances {
    std::vector<Instance> boxes, bars;
    std::array<std::vector<Instance>, kBallCorners.size()> balls;
};
/// `pixelsAMeter`: at 1 m from the eye; a ball of few pixels gets few triangles.
Instances instancesOf(const Frame& frame, float pixelsAMeter);

/// m; a rod that would be thinner in the picture is drawn a little wider than a pixel, so that no
/// row of it falls between the pixels' centres.
float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter);

/// All meshes, with the instances of one frame.
class Meshes {
public:
    Meshes();
    void set(const Instances& instances);
    void drawBoxes() const { boxes_.draw(); }
    void drawRound() const;
    /// All of them, front faces only, with a program that takes `worldToClip`.
    void drawWith(GLuint program, const Eigen::Matrix4f& worldToClip) const;

private:
    InstancedMesh boxes_, bars_;
    std::vector<InstancedMesh> balls_;  // as kBallCorners
};

}  // namespace render
