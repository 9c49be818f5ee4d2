/// A mesh that is drawn many times in one call.
#pragma once
#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "render/gl.h"
#include "render/material.h"
#include "render/vertex.h"

namespace render {

/// Neighbours in a list of instances.
struct InstanceRange {
    int first = 0, count = 0;
};

/// The instances of one mesh, in a buffer of the driver.
class InstanceList {
public:
    InstanceList() : buffer_(newBuffer()) {}
    /// `instances`: sorted by material.
    void set(const std::vector<Instance>& instances);
    /// Those of one material, or, without one, all that are not glass, which is the last material.
    InstanceRange of(std::optional<Material> material) const {
        if (material) return ranges_[indexOf(*material)];
        return {0, count_ - ranges_[indexOf(Material::glass)].count};
    }
    std::bitset<kMaterials> materials() const;

private:
    friend class InstancedMesh;
    GlBuffer buffer_;
    std::array<InstanceRange, kMaterials> ranges_{};
    int count_ = 0;
};

/// Identical corners are uploaded and shaded once.
class InstancedMesh {
public:
    explicit InstancedMesh(const std::vector<Vertex>& mesh);
    explicit InstancedMesh(const std::vector<FacetVertex>& mesh);
    void draw(const InstanceList& instances, std::optional<Material> material) const;

private:
    InstancedMesh(const void* vertices, std::size_t count, std::size_t size);

    GlArray array_;
    GlBuffer vertices_, indices_;
    int indexCount_ = 0;
};

}  // namespace render
