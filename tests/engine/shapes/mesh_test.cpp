#include "engine/shapes/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/shape.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Random heights on a grid of 30 by 20.
Shape hills() {
    support::Random random(11);
    std::vector<double> heights;
    for (int i = 0; i < 600; ++i) heights.push_back(random.number(0.0, 1.0));
    return Shape::heightField(30, 20, 0.5, heights);
}

TEST(Mesh, QueriesFindEveryTriangleThatMayTouch) {
    const Shape field = hills();
    const Mesh& mesh = *field.mesh;
    EXPECT_EQ(mesh.triangles.size(), 2u * 29 * 19);
    support::Random random(2);
    for (int run = 0; run < 200; ++run) {
        const Vec3 middle = random.vector(7.0);
        const Bounds within{middle - Vec3::Constant(0.4), middle + Vec3::Constant(0.4)};
        std::set<int> found;
        mesh.query(within, [&](int i) { EXPECT_TRUE(found.insert(i).second); });
        for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
            Bounds own{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
            for (const int c : mesh.triangles[i].corners)
                own = own.with({mesh.corners[c], mesh.corners[c]});
            if (own.overlaps(within)) {
                EXPECT_TRUE(found.count(i));
            }
        }
        EXPECT_LT(found.size(), 60u);
    }
}

TEST(Mesh, AHeightFieldLooksUp) {
    const Shape field = hills();
    for (const Mesh::Triangle& triangle : field.mesh->triangles)
        EXPECT_GT(triangle.normal.y(), 0.0);
}

/// A roof of two sides, and the same upside down: the ridge is sharp, the valley is not.
TEST(Mesh, SharpEdgesAreConvexOnesAndRims) {
    for (const double height : {1.0, -1.0, 0.0}) {
        const Vec3 corners[] = {{0, height, 0}, {0, height, 1}, {1, 0, 0}, {-1, 0, 1}};
        const std::array<int, 3> triangles[] = {{0, 1, 2}, {1, 0, 3}};
        const Mesh mesh = makeMesh(corners, triangles);
        ASSERT_EQ(mesh.triangles.size(), 2u);
        for (const Mesh::Triangle& triangle : mesh.triangles)
            for (int i = 0; i < 3; ++i) {
                const bool shared = triangle.corners[i] + triangle.corners[(i + 1) % 3] == 1;
                EXPECT_EQ(triangle.sharp[i], !shared || height > 0.0) << height;
            }
    }
}

TEST(Mesh, RidgesBentByLessThanTwoDegreesAreSlight) {
    for (const double height : {0.01, -0.01, 0.0, 1.0}) {
        const Vec3 corners[] = {{0, height, 0}, {0, height, 1}, {1, 0, 0}, {-1, 0, 1}};
        const std::array<int, 3> triangles[] = {{0, 1, 2}, {1, 0, 3}};
        const Mesh mesh = makeMesh(corners, triangles);
        for (const Mesh::Triangle& triangle : mesh.triangles)
            EXPECT_EQ(triangle.isAnySlight(), height == 0.01) << height;
        const std::vector<std::pair<int, int>> atFirst{{0, 1}, {0, 2}, {0, 3}};
        if (height == 0.01)
            EXPECT_TRUE(std::ranges::equal(mesh.besideOf(0), atFirst));
        else
            EXPECT_TRUE(mesh.besideOf(0).empty()) << height;
    }
}

TEST(Mesh, CornersInOnePlaceAreOneAndTrianglesWithoutAreaAreNone) {
    const Vec3 corners[] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {-1, 0, 0}};
    const std::array<int, 3> triangles[] = {{0, 1, 2}, {3, 4, 5}, {0, 4, 2}, {0, 2, 5}};
    const Mesh mesh = makeMesh(corners, triangles);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    int smooth = 0;
    for (const Mesh::Triangle& triangle : mesh.triangles)
        for (const bool sharp : triangle.sharp) smooth += sharp ? 0 : 1;
    EXPECT_EQ(smooth, 2);  // the common edge, once from each side
}

TEST(Mesh, WrongCallsStopTheProgram) {
    const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const std::array<int, 3> flat[] = {{0, 1, 2}}, beyond[] = {{0, 1, 3}};
    EXPECT_DEATH(Shape::meshOf(corners, flat), "with an area");
    EXPECT_DEATH(Shape::meshOf(corners, beyond), "three corners of its mesh");
    EXPECT_DEATH(Shape::heightField(2, 2, 1.0, std::vector<double>(3)), "height for each");
    World world;
    BodyDef def;
    def.shape = Shape::heightField(2, 2, 1.0, std::vector<double>(4));
    EXPECT_DEATH(world.add(def), "has no mass");
}

}  // namespace
}  // namespace engine
