#include "render/instanced_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace render {
namespace {

void attribute(GLuint index, int size, std::size_t stride, std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

/// The attributes per instance, read from the buffer that is bound, from instance `first` on.
void instanceAttributes(int first) {
    const auto each = [first](GLuint index, int size, std::size_t offset) {
        attribute(index, size, sizeof(Instance), first * sizeof(Instance) + offset, 1);
    };
    each(3, 3, offsetof(Instance, position));
    each(4, 4, offsetof(Instance, rotation));
    each(5, 3, offsetof(Instance, scale));
    each(6, 1, offsetof(Instance, stretch));
    each(7, 3, offsetof(Instance, color));
    each(8, 1, offsetof(Instance, surface));
}

/// The distinct corners, compared by their bytes, and the triangles as indices of corners.
struct Indexed {
    std::vector<char> corners;
    std::vector<std::uint32_t> triangles;
};

Indexed indexed(const char* vertices, std::size_t count, std::size_t size) {
    Indexed result;
    std::unordered_map<std::string_view, std::uint32_t> known;  // for lookup only
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view corner(vertices + i * size, size);
        const auto [at, isNew] = known.insert({corner, static_cast<std::uint32_t>(known.size())});
        if (isNew) result.corners.insert(result.corners.end(), corner.begin(), corner.end());
        result.triangles.push_back(at->second);
    }
    return result;
}

}  // namespace

/// The buffer of vertices stays bound.
InstancedMesh::InstancedMesh(const void* vertices, std::size_t count, std::size_t size)
    : array_(newArray()), vertices_(newBuffer()), indices_(newBuffer()),
      indexCount_(static_cast<int>(count)) {
    const Indexed mesh = indexed(static_cast<const char*>(vertices), count, size);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(std::uint32_t)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.corners.size()),
                 mesh.corners.data(), GL_STATIC_DRAW);
}

InstancedMesh::InstancedMesh(const std::vector<Vertex>& mesh)
    : InstancedMesh(mesh.data(), mesh.size(), sizeof(Vertex)) {
    attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position), 0);
    attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    attribute(2, 1, sizeof(Vertex), offsetof(Vertex, end), 0);
    attribute(9, 1, sizeof(Vertex), offsetof(Vertex, face), 0);
}

/// Has no ends: attributes without an array are 0.
InstancedMesh::InstancedMesh(const std::vector<FacetVertex>& mesh)
    : InstancedMesh(mesh.data(), mesh.size(), sizeof(FacetVertex)) {
    attribute(0, 3, sizeof(FacetVertex), offsetof(FacetVertex, position), 0);
    attribute(1, 3, sizeof(FacetVertex), offsetof(FacetVertex, normal), 0);
    attribute(9, 1, sizeof(FacetVertex), offsetof(FacetVertex, face), 0);
    attribute(10, 3, sizeof(FacetVertex), offsetof(FacetVertex, toEdges), 0);
    for (GLuint i = 0; i < 3; ++i)
        attribute(11 + i, 3, sizeof(FacetVertex),
                  offsetof(FacetVertex, beyond) + i * sizeof(Vec3), 0);
    attribute(14, 2, sizeof(FacetVertex), offsetof(FacetVertex, along), 0);
    attribute(15, 1, sizeof(FacetVertex), offsetof(FacetVertex, apothem), 0);
}

void InstanceList::set(const std::vector<Instance>& instances) {
    count_ = static_cast<int>(instances.size());
    ranges_ = {};
    for (int i = 0; i < count_; ++i) {
        InstanceRange& range = ranges_[indexOf(instances[i].material)];
        if (range.count++ == 0) range.first = i;
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                 instances.data(), GL_STREAM_DRAW);
}

std::bitset<kMaterials> InstanceList::materials() const {
    std::bitset<kMaterials> result;
    for (std::size_t i = 0; i < kMaterials; ++i) result[i] = ranges_[i].count > 0;
    return result;
}

void InstancedMesh::draw(const InstanceList& instances, std::optional<Material> material) const {
    const InstanceRange range = instances.of(material);
    if (range.count == 0) return;
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, instances.buffer_);
    instanceAttributes(range.first);
    glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr, range.count);
}

}  // namespace render
