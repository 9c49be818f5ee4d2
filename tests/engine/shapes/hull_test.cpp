#include "engine/shapes/hull.h"

#include <gtest/gtest.h>

#include "engine/shape.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

std::vector<Vec3> cubeCorners() {
    std::vector<Vec3> points;
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0})
            for (const double z : {0.0, 1.0}) points.push_back({x, y, z});
    return points;
}

TEST(Hull, FacesInOnePlaneAreOneAndPointsInsideAreNone) {
    std::vector<Vec3> points = cubeCorners();
    points.push_back({0.5, 0.5, 0.5});   // inside
    points.push_back({0.5, 1.0, 0.25});  // on a face
    points.push_back({1.0, 1.0, 1.0});   // a corner again
    const std::optional<Hull> hull = convexHull(points);
    ASSERT_TRUE(hull);
    EXPECT_EQ(hull->corners.size(), 8u);
    ASSERT_EQ(hull->faces.size(), 6u);
    for (const Hull::Face& face : hull->faces) {
        EXPECT_EQ(face.corners.size(), 4u);
        EXPECT_NEAR(face.normal.cwiseAbs().maxCoeff(), 1.0, 1e-15);
    }
}

/// V - E + F = 2; every corner is inside every face, every face is seen counter-clockwise.
TEST(Hull, OfRandomPointsIsAConvexPolyhedron) {
    support::Random random(3);
    for (int run = 0; run < 20; ++run) {
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i) points.push_back(random.vector(1.0) + Vec3(100, 0, 0));
        const std::optional<Hull> hull = convexHull(points);
        ASSERT_TRUE(hull);
        std::size_t sides = 0;
        for (const Hull::Face& face : hull->faces) {
            sides += face.corners.size();
            for (const Vec3& corner : hull->corners)
                EXPECT_LE(face.normal.dot(corner), face.offset);
            for (const Vec3& p : points) EXPECT_LT(face.normal.dot(p), face.offset + 1e-9);
            for (std::size_t i = 0; i < face.corners.size(); ++i) {
                const auto at = [&](std::size_t k) {
                    return hull->corners[face.corners[k % face.corners.size()]];
                };
                EXPECT_GT((at(i + 1) - at(i)).cross(at(i + 2) - at(i + 1)).dot(face.normal), 0.0);
            }
        }
        EXPECT_EQ(hull->corners.size() + hull->faces.size(), sides / 2 + 2);
    }
}

int firstFarthest(const std::vector<Vec3>& corners, const Vec3& d) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(corners.size()); ++i)
        if (d.dot(corners[i]) > d.dot(corners[best])) best = i;
    return best;
}

/// Also where corners are equally far, and where they do not fill the last block.
TEST(Hull, TheFarthestCornerIsTheFirstOfThem) {
    support::Random random(5);
    for (int count = 4; count < 20; ++count) {
        std::vector<Vec3> corners;
        for (int i = 0; i < count; ++i) corners.push_back(random.vector(1.0));
        for (int i = 0; i < 4; ++i) corners.push_back(corners[i]);
        const CornerLanes lanes(corners);
        for (int i = 0; i < 50; ++i) {
            const Vec3 d = random.vector(1.0);
            EXPECT_EQ(lanes.farthest(d), firstFarthest(corners, d));
        }
    }
    EXPECT_EQ(CornerLanes(cubeCorners()).farthest({0, 1, 0}), 2);
}

TEST(Hull, OfFlatOrTooFewOrBrokenPointsIsNone) {
    const Vec3 flat[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 1e-7}};
    EXPECT_FALSE(Shape::hullOf(flat));
    EXPECT_FALSE(Shape::hullOf(std::span(flat).first(3)));
    const Vec3 same[] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    EXPECT_FALSE(Shape::hullOf(same));
    std::vector<Vec3> broken = cubeCorners();
    broken[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(Shape::hullOf(broken));
    support::Random random(7);
    std::vector<Vec3> many;
    for (int i = 0; i < 400; ++i) many.push_back(random.vector(1.0).normalized());
    EXPECT_FALSE(Shape::hullOf(many));  // more than kMostCorners
    EXPECT_FALSE(Shape::hullOf({}));
}

TEST(Hull, AsAShapeIsCentredOnItsCentreOfMass) {
    const std::optional<Shape> cube = Shape::hullOf(cubeCorners());
    ASSERT_TRUE(cube);
    EXPECT_LT((cube->origin + Vec3::Constant(0.5)).norm(), 1e-15);
    EXPECT_NEAR(reachOf(*cube), std::sqrt(0.75), 1e-15);
    for (const Hull::Face& face : cube->hull->faces) EXPECT_NEAR(face.offset, 0.5, 1e-15);
}

}  // namespace
}  // namespace engine
