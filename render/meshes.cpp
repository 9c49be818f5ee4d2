#include "render/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace render {
namespace {

constexpr float kPi = 3.14159265f;

void attribute(GLuint index, int size, std::size_t stride, std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

}  // namespace

std::vector<Vertex> boxMesh() {
    std::vector<Vertex> mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const Vec3 normal = side * Vec3::Unit(axis);
            const Vec3 u = Vec3::Unit((axis + 1) % 3), v = normal.cross(u);
            const Vec3 corner[4] = {normal - u - v, normal + u - v, normal + u + v, normal - u + v};
            for (const int i : {0, 1, 2, 0, 2, 3}) mesh.push_back({corner[i], normal, 0.0f});
        }
    return mesh;
}

/// In rings; the equator is there twice, once for either end of a capsule.
std::vector<Vertex> ballMesh(int corners) {
    const int slices = corners, half = corners / 4;
    struct Ring {
        float angle, end;
    };
    std::vector<Ring> rings;
    const float right = kPi / 2, steps = static_cast<float>(half);
    for (int i = 0; i <= half; ++i)
        rings.push_back({right * static_cast<float>(i) / steps - right, -1.0f});
    for (int i = 0; i <= half; ++i) rings.push_back({right * static_cast<float>(i) / steps, 1.0f});
    const auto vertex = [slices](const Ring& ring, int slice) {
        const float share = static_cast<float>(slice % slices) / static_cast<float>(slices);
        const float turn = 2 * kPi * share;
        const Vec3 p(std::cos(ring.angle) * std::cos(turn), std::sin(ring.angle),
                     -std::cos(ring.angle) * std::sin(turn));
        return Vertex{p, p, ring.end};
    };
    std::vector<Vertex> mesh;
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (int s = 0; s < slices; ++s) {
            const Vertex a = vertex(rings[r], s), b = vertex(rings[r], s + 1);
            const Vertex c = vertex(rings[r + 1], s + 1), d = vertex(rings[r + 1], s);
            mesh.insert(mesh.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

/// A cylinder along y from -1 to 1, open: its ends are hidden in what it holds together.
std::vector<Vertex> barMesh() {
    constexpr int kSlices = 20;
    const auto vertex = [](int slice, float y) {
        const float turn = 2 * kPi * static_cast<float>(slice % kSlices) / kSlices;
        const Vec3 out(std::cos(turn), 0, -std::sin(turn));
        return Vertex{out + Vec3(0, y, 0), out, 0.0f};
    };
    std::vector<Vertex> mesh;
    for (int s = 0; s < kSlices; ++s) {
        const Vertex a = vertex(s, -1), b = vertex(s + 1, -1);
        const Vertex c = vertex(s + 1, 1), d = vertex(s, 1);
        mesh.insert(mesh.end(), {a, b, c, a, c, d});
    }
    return mesh;
}

InstancedMesh::InstancedMesh(const std::vector<Vertex>& mesh)
    : array_(newArray()), vertices_(newBuffer()), instances_(newBuffer()) {
    vertexCount_ = static_cast<int>(mesh.size());
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(Vertex)),
                 mesh.data(), GL_STATIC_DRAW);
    attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position), 0);
    attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    attribute(2, 1, sizeof(Vertex), offsetof(Vertex, end), 0);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    attribute(3, 3, sizeof(Instance), offsetof(Instance, position), 1);
    attribute(4, 4, sizeof(Instance), offsetof(Instance, rotation), 1);
    attribute(5, 3, sizeof(Instance), offsetof(Instance, scale), 1);
    attribute(6, 1, sizeof(Instance), offsetof(Instance, stretch), 1);
    attribute(7, 3, sizeof(Instance), offsetof(Instance, color), 1);
    attribute(8, 1, sizeof(Instance), offsetof(Instance, surface), 1);
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

namespace {

/// Place in kBallCorners: with n corners a circle is off by r (1 - cos(pi / n)).
std::size_t levelOf(float pixels) {
    constexpr float kOff = 0.33f;  // pixels
    std::size_t level = 0;
    while (level + 1 < kBallCorners.size()) {
        const float angle = kPi / static_cast<float>(kBallCorners[level]);
        if (pixels * 0.5f * angle * angle < kOff) break;
        ++level;
    }
    return level;
}

/// Nearest first, by the square of the distance from the eye.
void sortByDistance(std::vector<Instance>& instances, const Vec3& eye) {
    std::stable_sort(instances.begin(), instances.end(), [&](const Instance& a, const Instance& b) {
        return (a.position - eye).squaredNorm() < (b.position - eye).squaredNorm();
    });
}

void addRod(const Rod& rod, float radius, float surface, std::vector<Instance>& bars) {
    const Vec3 along = rod.to - rod.from;
    const float length = along.norm();
    if (length < 1e-6f) return;
    const Quat q = Quat::FromTwoVectors(Vec3::UnitY(), along);
    bars.push_back({0.5f * (rod.from + rod.to), q.coeffs(),
                    {radius, 0.5f * length, radius}, 0.0f, linear(rod.color), surface});
}

}  // namespace

float drawnRadius(const Rod& rod, const Vec3& eye, float pixelsAMeter) {
    constexpr float kThinnest = 0.55f;  // pixels
    const float away = std::max((rod.from - eye).norm(), (rod.to - eye).norm());
    return std::max(rod.radius, kThinnest * away / pixelsAMeter);
}

Instances instancesOf(const Frame& frame, float pixelsAMeter) {
    Instances result;
    const Vec3& eye = frame.camera.from;
    float surface = 0.0f;
    for (const Solid& s : frame.solids) {
        const float number = surface++;
        const Eigen::Vector4f q = s.rotation.normalized().coeffs();
        const Vec3 color = linear(s.color);
        if (s.shape == SolidShape::box) {
            result.boxes.push_back({s.position, q, s.halfSize, 0.0f, color, number});
            continue;
        }
        const float r = s.halfSize.x();
        const float pixels = r * pixelsAMeter / std::max((s.position - eye).norm(), 1e-3f);
        const float stretch = s.shape == SolidShape::capsule ? s.halfSize.y() : 0.0f;
        result.balls[levelOf(pixels)].push_back(
            {s.position, q, Vec3(r, r, r), stretch, color, number});
    }
    for (const Rod& rod : frame.rods)
        addRod(rod, drawnRadius(rod, eye, pixelsAMeter), surface++, result.bars);
    sortByDistance(result.boxes, eye);
    sortByDistance(result.bars, eye);
    for (std::vector<Instance>& balls : result.balls) sortByDistance(balls, eye);
    return result;
}

Meshes::Meshes() : boxes_(boxMesh()), bars_(barMesh()) {
    for (const int corners : kBallCorners) balls_.emplace_back(ballMesh(corners));
}

void Meshes::set(const Instances& instances) {
    boxes_.setInstances(instances.boxes);
    bars_.setInstances(instances.bars);
    for (std::size_t i = 0; i < balls_.size(); ++i) balls_[i].setInstances(instances.balls[i]);
}

void Meshes::drawRound() const {
    for (const InstancedMesh& ball : balls_) ball.draw();
    bars_.draw();
}

void Meshes::drawWith(GLuint program, const Eigen::Matrix4f& worldToClip) const {
    glUseProgram(program);
    setUniform(program, "worldToClip", worldToClip);
    glEnable(GL_CULL_FACE);
    drawBoxes();
    drawRound();
    glDisable(GL_CULL_FACE);
}

}  // namespace render
