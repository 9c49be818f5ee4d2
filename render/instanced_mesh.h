/// A mesh that is drawn many times in one call.
#pragma once
#include <vector>

#include "render/gl.h"
#include "render/vertex.h"

namespace render {

/// The instances of one mesh, in a buffer of the driver.
class InstanceList {
public:
    InstanceList() : buffer_(newBuffer()) {}
    void set(const std::vector<Instance>& instances);
    int count() const { return count_; }

private:
    friend class InstancedMesh;
    GlBuffer buffer_;
    int count_ = 0;
};

/// Identical corners are uploaded and shaded once.
class InstancedMesh {
public:
    explicit InstancedMesh(const std::vector<Vertex>& mesh);
    explicit InstancedMesh(const std::vector<FacetVertex>& mesh);
    void draw(const InstanceList& instances) const;

private:
    InstancedMesh(const void* vertices, std::size_t count, std::size_t size);

    GlArray array_;
    GlBuffer vertices_, indices_;
    int indexCount_ = 0;
};

}  // namespace render
