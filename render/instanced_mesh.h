/// Triangles that are drawn many times in one call.
#pragma once
#include <vector>

#include "render/gl.h"
#include "render/vertex.h"

namespace render {

class InstancedMesh {
public:
    explicit InstancedMesh(const std::vector<Vertex>& mesh);
    explicit InstancedMesh(const std::vector<FacetVertex>& mesh);
    void setInstances(const std::vector<Instance>& instances);
    void draw() const;

private:
    InstancedMesh(const void* vertices, std::size_t count, std::size_t size);

    GlArray array_;
    GlBuffer vertices_, instances_;
    int vertexCount_ = 0, instanceCount_ = 0;
};

}  // namespace render
