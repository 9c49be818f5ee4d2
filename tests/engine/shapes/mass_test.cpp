#include "engine/shapes/mass.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "engine/base/trigonometry.h"
#include "engine/dynamics/bodies.h"
#include "engine/shapes/inside.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

/// Volume and inertia of unit density, summed over a fine grid that fits the shape's bounds.
void sum(const Shape& s, const Vec3& reach, double& volumeSum, Mat3& inertiaSum) {
    constexpr int kCells = 120;
    const Vec3 cell = 2.0 * reach / kCells;
    volumeSum = 0.0;
    inertiaSum = Mat3::Zero();
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j)
            for (int k = 0; k < kCells; ++k) {
                const Vec3 p = Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(cell) - reach;
                if (!isInside(s, p)) continue;
                volumeSum += cell.prod();
                inertiaSum +=
                    cell.prod() * (p.squaredNorm() * Mat3::Identity() - p * p.transpose());
            }
}

TEST(Mass, VolumeAndInertiaAreTheIntegrals) {
    const Vec3 crooked[] = {{0, 0, 0}, {1, 0.1, 0}, {0.2, 0.9, 0.1}, {0.1, 0.2, 1.2}, {0.8, 0.7, 0.6}};
    const ShapePart parts[] = {
        {Shape::box({0.2, 0.8, 0.3}), {{0, 0, 0}, Quat::Identity()}},
        {Shape::sphere(0.25), {{0.5, 0.6, 0}, Quat::Identity()}},
        {Shape::cylinder(0.1, 0.5), {{-0.4, -0.2, 0.3}, turnAboutXyz({0.4, 0.3, 0.9})}}};
    const std::pair<Shape, Vec3> shapes[] = {{Shape::cylinder(0.4, 1.2), {0.4, 0.6, 0.4}},
                                             {Shape::cone(0.5, 1.2), {0.5, 0.9, 0.5}},
                                             {*Shape::hullOf(crooked), Vec3::Constant(1.0)},
                                             {Shape::compound(parts), Vec3::Constant(1.2)},
                                             {Shape::sphere(0.7), Vec3::Constant(0.7)},
                                             {Shape::box({1.0, 0.6, 1.5}), {0.5, 0.3, 0.75}},
                                             {Shape::capsule(0.3, 1.6), {0.3, 0.8, 0.3}}};
    for (const auto& [shape, reach] : shapes) {
        double v = 0.0;
        Mat3 inertia;
        sum(shape, reach, v, inertia);
        EXPECT_NEAR(volume(shape), v, 4e-3 * v);  // cells at the surface count as in or out
        EXPECT_LT((inertiaOf(shape, volume(shape)) - inertia).norm(), 8e-3 * inertia.norm());
    }
}

/// A dumbbell: I = I_1 + I_2 + m d^2 each, about where the two masses balance.
TEST(Mass, PartsWeighAsTheyAreDense) {
    const ShapePart parts[] = {{Shape::sphere(0.5), {{-1, 0, 0}, Quat::Identity()}, 3.0},
                               {Shape::sphere(0.5), {{2, 0, 0}, Quat::Identity()}}};
    const double ball = 200.0 * volume(Shape::sphere(0.5));
    const Shape dumbbell = Shape::compound(parts);
    EXPECT_NEAR(massOf(dumbbell, 200.0), 4.0 * ball, 1e-10);
    EXPECT_NEAR(volume(dumbbell), 2.0 * volume(Shape::sphere(0.5)), 1e-15);
    EXPECT_NEAR((dumbbell.origin - Vec3(0.25, 0, 0)).norm(), 0.0, 1e-15);
    const double along = 4.0 * ball * 0.4 * 0.25;  // 2/5 m r^2
    const double across = along + 3.0 * ball * 0.75 * 0.75 + ball * 2.25 * 2.25;
    const Vec3 expected(along, across, across);
    EXPECT_LT((inertiaOf(dumbbell, 4.0 * ball) - Mat3(expected.asDiagonal())).norm(), 1e-10);
    // As a part of a compound it keeps its own parts.
    const ShapePart whole[] = {{dumbbell, {{0, 0, 0}, Quat::Identity()}, 2.0}};
    EXPECT_NEAR(massOf(Shape::compound(whole), 100.0), 4.0 * ball, 1e-10);
}

// mission 4: box 1 x 2 x 4 m, 12 kg
TEST(Mass, WorldInertiaIsRIR) {
    BodyDef def = support::body(Shape::box({1, 2, 4}), Vec3::Zero(), 12.0);
    EXPECT_LT((inertiaOf(def.shape, 12.0).diagonal() - Vec3(20, 17, 5)).norm(), 1e-12);
    def.pose.rotation = turnAbout(Vec3::UnitZ(), radians(90));
    Bodies bodies;
    addBody(bodies, def, bodies.count());
    const Vec3 dw = bodies.inverseMasses[0].angular * Vec3(0, 1, 0).cross(Vec3(0, 0, 1));
    EXPECT_LT((dw - Vec3(1.0 / 17.0, 0, 0)).norm(), 1e-15);
}

TEST(Mass, ATensorWithProductsOfInertiaWorks) {
    Mat3 inertia;
    inertia << 3.0, 0.4, -0.2, 0.4, 2.0, 0.3, -0.2, 0.3, 4.0;
    BodyDef def = support::body(Shape::sphere(1), Vec3::Zero());
    def.inertia = inertia;
    def.pose.rotation = Quat(0.5, -0.1, 0.7, 0.2).normalized();
    Bodies bodies;
    addBody(bodies, def, bodies.count());
    const Mat3 r = bodies.poses[0].rotation.toRotationMatrix();
    const Mat3 expected = (r * inertia * r.transpose()).inverse();
    EXPECT_LT((bodies.inverseMasses[0].angular - expected).norm(), 1e-14);
}

TEST(Mass, NoPrincipalMomentIsLargerThanTheSumOfTheOthers) {
    const auto diagonal = [](double a, double b, double c) {
        return Mat3(Vec3(a, b, c).asDiagonal());
    };
    const Mat3 turn = Quat(0.5, 0.1, -0.7, 0.3).normalized().toRotationMatrix();
    for (const double size : {1e-12, 1.0, 1e12}) {
        EXPECT_TRUE(isInertia(size * diagonal(1, 2, 3))) << "a plate";
        EXPECT_TRUE(isInertia(size * turn * diagonal(1, 2, 2.9) * turn.transpose()));
        EXPECT_FALSE(isInertia(size * diagonal(1, 2, 3.01)));
        EXPECT_FALSE(isInertia(size * turn * diagonal(1, 2, 3.01) * turn.transpose()));
        EXPECT_FALSE(isInertia(size * diagonal(1, -1, 1)));
    }
    EXPECT_FALSE(isInertia(diagonal(1, 1, std::nan(""))));
    EXPECT_FALSE(isInertia(Mat3::Zero()));
}

TEST(Mass, AnInertiaThatIsNoneStopsTheProgram) {
    BodyDef def = support::body(Shape::sphere(1), Vec3::Zero());
    def.inertia = Mat3(Vec3(1, 1, -1).asDiagonal());
    Bodies bodies;
    EXPECT_DEATH(addBody(bodies, def, bodies.count()), "positive definite");
}

TEST(Inside, EndsAtTheSurfaceOrAGivenWayBeyondIt) {
    struct Place {
        Shape shape;
        Vec3 onSurface, normal;
    };
    const Shape pill = Shape::capsule(0.25, 1.3), disc = Shape::cylinder(1.0, 0.2);
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
    const Place places[] = {{Shape::sphere(0.5), {0.3, 0.4, 0}, {0.6, 0.8, 0}},
                            {Shape::box({1, 2, 3}), {0.1, 1.0, 0.2}, y},
                            {Shape::plane(y), {5, 0, 2}, y},
                            {pill, {0.25, 0.1, 0}, x},
                            {pill, {0, pill.halfLength + 0.25, 0}, y},
                            {disc, {1.0, 0, 0}, x},
                            {disc, {0.3, 0.1, 0}, y}};
    for (const Place& p : places) {
        EXPECT_TRUE(isInside(p.shape, p.onSurface - 0.01 * p.normal));
        EXPECT_FALSE(isInside(p.shape, p.onSurface + 0.01 * p.normal));
        EXPECT_TRUE(isInside(p.shape, p.onSurface + 0.01 * p.normal, 0.02));
        EXPECT_FALSE(isInside(p.shape, p.onSurface + 0.03 * p.normal, 0.02));
    }
}

}  // namespace
}  // namespace engine
