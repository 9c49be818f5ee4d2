#include "engine/collision/ray_cast.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/base/trigonometry.h"
#include "engine/shapes/inside.h"
#include "engine/world.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

constexpr int kSteps = 20000;

/// By many small steps; 2: never.
double walk(const Shape& shape, const Pose& pose, const Vec3& from, const Vec3& to) {
    for (int i = 0; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        if (isInside(shape, pose.toLocal(from + t * (to - from)))) return t;
    }
    return 2.0;
}

Pose somePose() {
    Pose pose;
    pose.position = {0.3, -0.2, 0.5};
    pose.rotation = Quat(Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()));
    return pose;
}

TEST(RayCast, EntersWhereAWalkAlongItGetsInside) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-2.5, 2.5);
    const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    const Pose pose = somePose();
    const Vec3 corners[] = {{0, 0, 0}, {2, 0.1, 0}, {0.2, 1.8, 0.1}, {0.1, 0.2, 2}, {1.5, 1.4, 1}};
    const ShapePart parts[] = {{Shape::box({0.6, 0.8, 1.3}), {{0.2, 0, 0}, Quat::Identity()}},
                               {Shape::sphere(0.6), {{1.1, 0.6, 0}, Quat::Identity()}}};
    for (const Shape& shape : {Shape::sphere(0.8), Shape::box({1.0, 0.6, 1.8}),
                               Shape::capsule(0.4, 2.0), Shape::plane({1, 2, -1}),
                               Shape::cylinder(0.6, 1.4), Shape::cone(0.8, 1.5),
                               *Shape::hullOf(corners), Shape::compound(parts)}) {
        int hits = 0, misses = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = point(), to = point();
            if (isInside(shape, pose.toLocal(from))) {
                EXPECT_FALSE(enterShape(shape, pose, from, to)) << i;
                continue;
            }
            const auto hit = enterShape(shape, pose, from, to);
            EXPECT_NEAR(hit ? hit->fraction : 2.0, walk(shape, pose, from, to), 1.1 / kSteps)
                << static_cast<int>(shape.type) << " " << i;
            ++(hit ? hits : misses);
            if (!hit) continue;
            // The normal points out: a step along it leaves the body, one against it enters.
            const Vec3 at = from + hit->fraction * (to - from);
            EXPECT_NEAR(hit->normal.norm(), 1.0, 1e-12);
            EXPECT_LE(hit->normal.dot(to - from), 0.0);
            EXPECT_FALSE(isInside(shape, pose.toLocal(at + 1e-6 * hit->normal)));
            EXPECT_TRUE(isInside(shape, pose.toLocal(at - 1e-6 * hit->normal)));
        }
        EXPECT_GT(hits, 8) << static_cast<int>(shape.type);
        EXPECT_GT(misses, 8) << static_cast<int>(shape.type);
    }
}

TEST(RayCast, WaysAlongAxesAndThroughEndsAreNoSpecialCase) {
    const Pose pose;
    const Shape box = Shape::box({2, 2, 2}), capsule = Shape::capsule(0.5, 3.0);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const Vec3 from = 5.0 * side * Vec3::Unit(axis);
            const auto hit = enterShape(box, pose, from, -from);
            ASSERT_TRUE(hit);
            EXPECT_DOUBLE_EQ(hit->fraction, 0.4);
            EXPECT_EQ(hit->normal, Vec3(side * Vec3::Unit(axis)));
        }
    // A way along faces of a hull: between them, and beside them.
    std::vector<Vec3> corners;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) corners.push_back({x, y, z});
    const Shape hull = *Shape::hullOf(corners);
    const auto front = enterShape(hull, pose, {5, 0.5, 0}, {-5, 0.5, 0});
    ASSERT_TRUE(front);
    EXPECT_DOUBLE_EQ(front->fraction, 0.4);
    EXPECT_FALSE(enterShape(hull, pose, {5, 1.5, 0}, {-5, 1.5, 0}));
    const auto tip = enterShape(capsule, pose, {0, 5, 0}, {0, -5, 0});
    ASSERT_TRUE(tip);
    EXPECT_DOUBLE_EQ(tip->fraction, 0.35);
    EXPECT_FALSE(enterShape(box, pose, {0, 1.5, 0}, {0, 1.5, 9}));    // beside it
    EXPECT_FALSE(enterShape(box, pose, {0, 3, 0}, {0, 1.5, 0}));      // ends before
    EXPECT_FALSE(enterShape(box, pose, {0, 3, 0}, {0, 9, 0}));        // leads away
    EXPECT_FALSE(enterShape(capsule, pose, {0, 3, 0}, {0, 3, 0}));    // zero length
    EXPECT_FALSE(enterShape(Shape::plane({0, 1, 0}), pose, {0, 1, 0}, {5, 1, 0}));
}

TEST(RayCast, ABoxAndTheHullOfItsCornersAgreeOnWaysOfAnyLength) {
    const Vec3 half{0.5, 0.3, 0.9};
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(half.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    const Shape box = Shape::box(2.0 * half), hull = *Shape::hullOf(corners);
    support::Random random(4);
    int hits = 0, misses = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 through = random.vector(1.0), way = (i % 2 ? 0.3 : 30.0) * random.vector(1.0);
        const Vec3 from = through - random.number(0.0, 1.0) * way;
        if (isInside(box, from)) continue;
        const auto a = enterShape(box, {}, from, from + way), b = enterShape(hull, {}, from, from + way);
        ASSERT_EQ(a.has_value(), b.has_value()) << i;
        ++(a ? hits : misses);
        if (!a) continue;
        EXPECT_NEAR(a->fraction, b->fraction, 1e-9) << i;
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(misses, 100);
}

TEST(RayCast, IsAsGoodFarAway) {
    const Pose pose;
    const auto hit = enterShape(Shape::sphere(0.5), pose, {1e7, 0.3, 0}, {-1e7, 0.3, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(1e7 - hit->fraction * 2e7, 0.4, 1e-6);
}

class Rays : public testing::Test {
protected:
    BodyId add(const Shape& shape, const Vec3& at, BodyKind kind = BodyKind::dynamic) {
        BodyDef def;
        def.shape = shape;
        def.kind = kind;
        def.pose.position = at;
        return world.add(def);
    }
    World world;
};

TEST_F(Rays, FindTheFirstBody) {
    const BodyId floor = add(Shape::plane({0, 1, 0}), {0, 0, 0}, BodyKind::fixed);
    const BodyId low = add(Shape::sphere(0.5), {0, 2, 0}), high = add(Shape::sphere(0.5), {0, 4, 0});
    const auto hit = world.castRay({0, 10, 0}, {0, -10, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->body, high);
    EXPECT_NEAR((hit->point - Vec3(0, 4.5, 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(hit->fraction, 0.275, 1e-12);
    EXPECT_EQ(world.castRay({0, -5, 0}, {0, 9, 0})->body, low);  // it begins inside the floor
    EXPECT_EQ(world.castRay({3, 10, 0}, {3, -10, 0})->body, floor);
    EXPECT_FALSE(world.castRay({3, 10, 0}, {3, 1, 0}));
    const auto filtered = world.castRay({0, 10, 0}, {0, -10, 0},
                                        [high](BodyId id) { return id != high; });
    EXPECT_EQ(filtered->body, low);
}

TEST_F(Rays, FollowWhatMovesComesAndGoes) {
    const BodyId ball = add(Shape::sphere(0.5), {0, 4, 0});
    world.setVelocity(ball, {6, 0, 0}, Vec3::Zero());
    world.setGravity(Vec3::Zero());
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(world.step(1.0 / 60.0));
    EXPECT_FALSE(world.castRay({0, 9, 0}, {0, -9, 0}));
    EXPECT_EQ(world.castRay({6, 9, 0}, {6, -9, 0})->body, ball);
    Pose back;
    back.position = {-2, 0, 0};
    world.setPose(ball, back);  // before any step
    EXPECT_EQ(world.castRay({-2, 9, 0}, {-2, -9, 0})->body, ball);
    world.remove(ball);
    EXPECT_FALSE(world.castRay({-2, 9, 0}, {-2, -9, 0}));
}

TEST_F(Rays, PassThroughWhatDoesNotCollideUnlessItIsWanted) {
    BodyDef ghost;
    ghost.collide = false;
    const BodyId id = world.add(ghost);
    EXPECT_FALSE(world.castRay({0, 9, 0}, {0, -9, 0}));
    EXPECT_EQ(world.castRay({0, 9, 0}, {0, -9, 0}, [](BodyId) { return true; })->body, id);
}

TEST_F(Rays, ChangeNothing) {
    add(Shape::plane({0, 1, 0}), {0, 0, 0}, BodyKind::fixed);
    add(Shape::box({1, 1, 1}), {0, 0.5, 0});
    world.step(1.0 / 60.0);
    const std::uint64_t before = world.hash();
    world.castRay({0, 9, 0}, {0, -9, 0});
    EXPECT_EQ(world.hash(), before);
}

// The tree of bounds compared with testing every body, while bodies fly, are added, removed and moved.
TEST(RayCast, FindsTheFirstOfAllBodies) {
    support::Random random(5);
    World world;
    world.add(support::floorPlane());
    std::vector<BodyId> bodies;
    const auto place = [&] { return Vec3(8.0 * random.vector(1)); };
    const auto add = [&] {
        const double size = random.number(0.1, 1.0);
        const bool ball = random.number(0, 1) < 0.5;
        bodies.push_back(world.add(support::body(
            ball ? Shape::sphere(size) : Shape::box({size, 1.0, 2.0 * size}), place())));
        world.setVelocity(bodies.back(), 5.0 * random.vector(1), random.vector(1));
    };
    for (int i = 0; i < 100; ++i) add();
    int hits = 0;
    for (int step = 0; step < 40; ++step) {
        for (int k = 0; k < 50; ++k) {
            const Vec3 from = place(), to = step % 3 ? place() : Vec3(from + Vec3(0, -9, 0));
            double nearest = 2.0;
            for (const BodyId id : bodies)
                if (const auto hit = enterShape(world.def(id).shape, world.pose(id), from, to))
                    nearest = smaller(nearest, hit->fraction);
            if (const auto floor = enterShape(world.def({0}).shape, world.pose({0}), from, to))
                nearest = smaller(nearest, floor->fraction);
            const auto seen = world.castRay(from, to);
            EXPECT_EQ(seen ? seen->fraction : 2.0, nearest) << step << " " << k;
            hits += seen.has_value();
        }
        if (step % 4 == 1) world.step(support::kStep);
        if (step % 4 == 2) world.setPose(bodies[step], {place(), Quat::Identity()});
        if (step % 4 == 3) world.remove(bodies.front()), bodies.erase(bodies.begin()), add();
    }
    EXPECT_GT(hits, 500);
}

TEST(RaysDeathTest, OfNoPlaceAreTheCallersBug) {
    const World world;
    EXPECT_DEATH(world.castRay({std::nan(""), 0, 0}, {0, 1, 0}), "must be finite");
}

/// Straight down on hills: the height of the triangle below.
TEST(RayCast, MeetsAHeightFieldFromAboveOnly) {
    std::vector<double> heights;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 9; ++i) heights.push_back(0.2 * i + 0.1 * j);  // a slope
    const Shape field = Shape::heightField(9, 9, 0.5, heights);
    for (const double x : {-1.9, -0.33, 0.0, 1.25})
        for (const double z : {-1.7, 0.21, 1.9}) {
            const double height = 0.2 * (x / 0.5 + 4.0) + 0.1 * (z / 0.5 + 4.0);
            const auto hit = enterShape(field, {}, {x, 5, z}, {x, -5, z});
            ASSERT_TRUE(hit);
            EXPECT_NEAR(5.0 - 10.0 * hit->fraction, height, 1e-9);
            EXPECT_LT((hit->normal - Vec3(-0.4, 1, -0.2).normalized()).norm(), 1e-9);
            EXPECT_FALSE(enterShape(field, {}, {x, -5, z}, {x, 5, z}));
        }
    EXPECT_FALSE(enterShape(field, {}, {3, 5, 0}, {3, -5, 0}));
}

}  // namespace
}  // namespace engine
