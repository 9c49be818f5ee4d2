// The triangles of balls and half balls.
#include "render/unit_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "render/instances.h"

namespace render {
namespace {

using Key = std::array<int, 4>;  // a place and an end, rounded

Key keyOf(const Vertex& v) {
    const auto rounded = [](float x) { return static_cast<int>(std::lround(1e5f * x)); };
    return {rounded(v.position.x()), rounded(v.position.y()), rounded(v.position.z()),
            rounded(v.end)};
}

/// How often each edge is used from a to b, less how often from b to a; triangles without area use
/// none.
std::map<std::array<Key, 2>, int> openEdges(const std::vector<Vertex>& mesh) {
    std::map<std::array<Key, 2>, int> edges;
    for (std::size_t i = 0; i < mesh.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const Key a = keyOf(mesh[i + k]), b = keyOf(mesh[i + (k + 1) % 3]);
            if (a == b) continue;
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
    return edges;
}

Vec3 areaOf(const std::vector<Vertex>& mesh, std::size_t i) {
    return (mesh[i + 1].position - mesh[i].position).cross(mesh[i + 2].position - mesh[i].position);
}

class Balls : public testing::TestWithParam<int> {};

TEST_P(Balls, AreClosedAndFaceOutwards) {
    const std::vector<Vertex> mesh = ballMesh(GetParam());
    EXPECT_TRUE(openEdges(mesh).empty());
    float volume = 0.0f;
    for (std::size_t i = 0; i < mesh.size(); i += 3) {
        EXPECT_GE(areaOf(mesh, i).dot(mesh[i].position + mesh[i + 1].position), -1e-6f);
        volume += areaOf(mesh, i).dot(mesh[i].position) / 6.0f;
    }
    EXPECT_GT(volume, GetParam() < 16 ? 3.4f : 3.7f);  // of 4.19
    for (const Vertex& v : mesh) EXPECT_NEAR(v.position.norm(), 1.0f, 1e-6f);
}

TEST_P(Balls, HaveHalvesThatAreOpenAtTheRimOnly) {
    const int corners = GetParam();
    const std::vector<Vertex> mesh = domeMesh(corners);
    const auto rim = openEdges(mesh);
    EXPECT_EQ(rim.size(), static_cast<std::size_t>(corners));
    for (const auto& [edge, times] : rim) {
        EXPECT_EQ(std::abs(times), 1);
        EXPECT_EQ(edge[0][1], 0) << "an edge above the rim is open";
        EXPECT_EQ(edge[1][1], 0);
    }
    for (std::size_t i = 0; i < mesh.size(); i += 3)
        EXPECT_GT(areaOf(mesh, i).dot(mesh[i].position), 0.0f);
    for (const Vertex& v : mesh) {
        EXPECT_NEAR(v.position.norm(), 1.0f, 1e-6f);
        EXPECT_EQ(v.position, v.normal);
        EXPECT_GE(v.position.y(), 0.0f);
    }
    EXPECT_LT(3 * mesh.size(), ballMesh(corners).size());
}

INSTANTIATE_TEST_SUITE_P(Corners, Balls, testing::ValuesIn(kBallCorners),
                         [](const auto& one) { return std::to_string(one.param); });

Frame ballAt(float away, Material material) {
    Frame frame;
    frame.camera.from = Vec3(0, 0, away), frame.camera.lookAt = Vec3::Zero();
    Solid ball;
    ball.shape = SolidShape::sphere, ball.halfSize.setConstant(0.5f), ball.material = material;
    frame.solids = {ball};
    return frame;
}

std::size_t countOf(const ByCorners& levels) {
    std::size_t count = 0;
    for (const std::vector<Instance>& level : levels) count += level.size();
    return count;
}

TEST(HalfBalls, FaceTheEyeAndTheSun) {
    const Frame frame = ballAt(20.0f, Material::plastic);
    const Vec3 sun(1, 2, 3);
    const Instances drawn = instancesOf(frame, 1000.0f, sun);
    ASSERT_EQ(countOf(drawn.domes), 1u);
    EXPECT_EQ(countOf(drawn.balls), 0u);
    for (const std::vector<Instance>& level : drawn.domes)
        for (const Instance& dome : level)
            EXPECT_LT((Quat(dome.rotation) * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-6f);
    EXPECT_LT((Quat(drawn.towardsSun) * Vec3::UnitY() - sun.normalized()).norm(), 1e-6f);
}

TEST(HalfBalls, AreNotDrawnWhereMoreIsSeen) {
    const Vec3 sun(0, 1, 0);
    Frame mirrored = ballAt(20.0f, Material::plastic);
    mirrored.look.reflection = 0.5f;
    for (const Frame& frame : {ballAt(20.0f, Material::wood), ballAt(1.0f, Material::plastic), mirrored}) {
        const Instances drawn = instancesOf(frame, 1000.0f, sun);
        EXPECT_EQ(countOf(drawn.domes), 0u);
        EXPECT_EQ(countOf(drawn.balls), 1u);
    }
}

}  // namespace
}  // namespace render
