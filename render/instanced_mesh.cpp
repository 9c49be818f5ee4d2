#include "render/instanced_mesh.h"

#include <cstddef>

namespace render {
namespace {

void attribute(GLuint index, int size, std::size_t stride, std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

}  // namespace

/// Leaves the buffer of vertices bound.
InstancedMesh::InstancedMesh(const void* vertices, std::size_t count, std::size_t size)
    : array_(newArray()), vertices_(newBuffer()), instances_(newBuffer()),
      vertexCount_(static_cast<int>(count)) {
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    attribute(3, 3, sizeof(Instance), offsetof(Instance, position), 1);
    attribute(4, 4, sizeof(Instance), offsetof(Instance, rotation), 1);
    attribute(5, 3, sizeof(Instance), offsetof(Instance, scale), 1);
    attribute(6, 1, sizeof(Instance), offsetof(Instance, stretch), 1);
    attribute(7, 3, sizeof(Instance), offsetof(Instance, color), 1);
    attribute(8, 1, sizeof(Instance), offsetof(Instance, surface), 1);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * size), vertices, GL_STATIC_DRAW);
}

InstancedMesh::InstancedMesh(const std::vector<Vertex>& mesh)
    : InstancedMesh(mesh.data(), mesh.size(), sizeof(Vertex)) {
    attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position), 0);
    attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    attribute(2, 1, sizeof(Vertex), offsetof(Vertex, end), 0);
    attribute(9, 1, sizeof(Vertex), offsetof(Vertex, face), 0);
}

/// Without ends: what no array gives is 0.
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

void InstancedMesh::setInstances(const std::vector<Instance>& instances) {
    instanceCount_ = static_cast<int>(instances.size());
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                 instances.data(), GL_STREAM_DRAW);
}

void InstancedMesh::draw() const {
    if (instanceCount_ == 0) return;
    glBindVertexArray(array_);
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertexCount_, instanceCount_);
}

}  // namespace render
