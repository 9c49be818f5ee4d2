/// Box, ball and bar as triangles, and the instances of a frame that are drawn with them.
#pragma once
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
};

enum class MeshKind { box, ball, bar };

/// One kind of mesh, drawn many times in one call.
class InstancedMesh {
public:
    explicit InstancedMesh(MeshKind kind);
    void setInstances(const std::vector<Instance>& instances);
    void draw() const;

private:
    GlArray array_;
    GlBuffer vertices_, instances_;
    int vertexCount_ = 0, instanceCount_ = 0;
};

std::vector<Vertex> meshOf(MeshKind kind);

/// Solids and rods of a frame, by mesh.
struct Instances {
    std::vector<Instance> boxes, balls, bars;
};
Instances instancesOf(const Frame& frame);

}  // namespace render
