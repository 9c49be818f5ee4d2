/// Materials and meshes of a .glb, each once: equal triangles are shared.
#pragma once
#include <map>
#include <utility>

#include "demos/export/glb_buffer.h"
#include "demos/export/triangles.h"

namespace demos {

class GlbMeshes {
public:
    explicit GlbMeshes(GlbBuffer& buffer) : buffer_(buffer) {}

    /// The number of a material, translucent if the colour is.
    int materialOf(const render::Color& color, render::Material look = render::Material::plastic);
    /// The number of a mesh.
    int meshOf(const Triangles& triangles, int material);

    /// A file's `materials` and `meshes`.
    const GlbJson& materials() const { return materials_; }
    const GlbJson& meshes() const { return meshes_; }

private:
    /// The accessors of triangles.
    struct Accessors {
        int positions, normals, corners;
    };
    const std::pair<int, Accessors>& shared(const Triangles& triangles);

    GlbBuffer& buffer_;
    GlbJson materials_ = GlbJson::array(), meshes_ = GlbJson::array();
    std::map<std::array<float, 6>, int> byValues_;
    std::map<Triangles, std::pair<int, Accessors>> shared_;
    std::map<std::pair<int, int>, int> byParts_;  // triangles and material
};

}  // namespace demos
