// Loops of joints of every type, some held twice, that do not fit: they have no exact solution, or one that is
// hardly determined. They may lose energy, but not gain any.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/support/joints.h"

namespace engine {
namespace {

using support::Random;

constexpr JointType kTypes[] = {JointType::ball,     JointType::hinge,            JointType::weld,
                                JointType::slider,   JointType::constantVelocity, JointType::sixDof,
                                JointType::universal};
constexpr double kSettling = 0.2;  // s, in which the joints close as far as they can

struct Misfit {
    World world;
    Random random;
    double radius, misfit;  // m
    double scale = 0.0;     // J
    std::vector<BodyId> bars;

    Misfit(int number, const Settings& settings)
        : world(settings), random(static_cast<std::uint64_t>(number) + 1) {
        radius = random.number(0.3, 2.0);
        misfit = radius * std::pow(10.0, random.number(-5.0, -1.3));
        const bool parallel = number % 3 == 0, mixed = number % 2 == 0;
        const int count = static_cast<int>(random.number(3, 13));
        addBars(count);
        JointType type = anyType();
        for (int i = 0; i < count; ++i) {
            if (mixed) type = anyType();
            join(bars[i], bars[(i + 1) % count], at(i + 1, count), type, parallel);
        }
        join(world.add(support::hook(at(0, count))), bars[0], at(0, count), JointType::ball, false);
        if (mixed && count > 4) join(bars[0], bars[count / 2], at(count / 2, count), anyType(), parallel);
    }

    Vec3 at(int corner, int count) const {
        const double angle = 2.0 * std::numbers::pi * corner / count;
        return radius * Vec3(std::cos(angle), std::sin(angle), 0);
    }
    JointType anyType() { return kTypes[static_cast<int>(random.number(0, std::size(kTypes)))]; }

    void addBars(int count) {
        const double mass = std::pow(10.0, random.number(-2, 2));
        for (int i = 0; i < count; ++i) {
            const Vec3 from = at(i, count), to = at(i + 1, count), way = to - from;
            BodyDef bar = support::body(Shape::box({way.norm(), 0.05, 0.05}), 0.5 * (from + to),
                                        mass * std::pow(10.0, random.number(-0.5, 0.5)));
            bar.pose.rotation = support::turnInPlane(way);
            bar.velocity = random.vector(2);
            bar.collide = false;
            bars.push_back(world.add(bar));
            scale += world.mass(bars.back()) * support::kGravity * radius;
        }
    }

    void join(BodyId a, BodyId b, const Vec3& where, JointType type, bool parallel) {
        const Vec3 axis = parallel ? Vec3(Vec3::UnitZ()) : Vec3(random.vector(1).normalized());
        JointDef def = support::jointAt(world, type, a, b, where, axis, axis);
        if (type == JointType::universal || type == JointType::sixDof)
            def.axis2 = axis.cross(Vec3(0.3, 0.5, 0.9)).normalized();
        for (int i = 0; type == JointType::sixDof && i < 6; ++i)
            def.free[i].locked = i < 3 || random.number(0, 1) < 0.5;
        if (type == JointType::slider) def.free[0].limits = {-0.5, 0.5};
        def.anchorA += random.vector(misfit);
        def.anchorB += random.vector(misfit);
        world.add(def);
    }
};

void expectNoGain(int number, const Settings& settings) {
    Misfit ring(number, settings);
    support::run(ring.world, static_cast<int>(kSettling / support::kStep));
    const double most = ring.world.energy().total() + 0.2 * ring.scale;
    for (int step = 0; step < 600; ++step) {
        ASSERT_TRUE(ring.world.step(support::kStep));
        ASSERT_LT(ring.world.energy().total(), most) << number << ", step " << step;
    }
    EXPECT_LT(ring.world.errors().separation, 0.05 * ring.radius + 3.0 * ring.misfit) << number;
}

void expectNoGain(const Settings& settings) {
    const int rings = std::getenv("IMPULSE_LONG") ? 300 : 30;
    for (int number = 0; number < rings; ++number) expectNoGain(number, settings);
}
TEST(Misfits, NeverGainEnergyInPresetSteady) { expectNoGain(Settings::steady()); }
TEST(Misfits, NeverGainEnergyInPresetFast) { expectNoGain(Settings::fast()); }

/// Four cubes that all overlap, each welded to the next.
std::vector<BodyId> addPiece(World& world, const Vec3& at) {
    std::vector<BodyId> parts;
    for (int i = 0; i < 4; ++i) {
        parts.push_back(world.add(support::body(Shape::box({1, 1, 1}), at + Vec3(0.1 * i, 0, 0.05 * i), 1.0 + i)));
        if (i > 0) world.add(support::jointAt(world, JointType::weld, parts[i - 1], parts[i], at));
    }
    return parts;
}

TEST(Welds, MakeOnePieceWhosePartsDoNotCollide) {
    World world;
    world.setGravity(Vec3::Zero());
    for (const BodyId part : addPiece(world, Vec3::Zero())) world.setVelocity(part, Vec3::Zero(), {1, 2, 3});
    world.step(support::kStep);  // the velocities fit the welds
    const double energy = world.energy().total();
    support::run(world, 600);
    EXPECT_EQ(world.errors().contacts, 0);
    EXPECT_NEAR(world.energy().total(), energy, 1e-3 * energy);
    EXPECT_LT(world.joint({0}).force.norm(), 100.0);
}

TEST(Welds, ToTheWorldLetABodyStandInTheFloor) {
    World world;
    world.add(support::floorPlane());
    const std::vector<BodyId> parts = addPiece(world, {0, 0.2, 0});
    const JointId foot = world.add(support::jointAt(world, JointType::weld, world.add(support::hook()), parts[0], Vec3::Zero()));
    const Vec3 before = world.pose(parts[3]).position;
    support::run(world, 600);
    EXPECT_EQ(world.errors().contacts, 0);
    EXPECT_LT((world.pose(parts[3]).position - before).norm(), 1e-6);
    EXPECT_NEAR(world.joint(foot).force.y(), 10 * support::kGravity, 1e-3);
}

}  // namespace
}  // namespace engine
