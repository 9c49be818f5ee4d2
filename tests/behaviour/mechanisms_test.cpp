// Mechanisms without friction keep their energy for any time: chains of any number of links, with any joint,
// released level; and loops.
#include <gtest/gtest.h>

#include "tests/support/joints.h"
#include "tests/support/worlds.h"

namespace engine {
namespace {

using support::body;

/// The lowest and the highest energy of a run, relative to the first, divided by the given scale.
struct EnergyRange {
    double low = 0.0, high = 0.0, separation = 0.0;

    void run(World& world, double seconds, double scale, double hz = 60.0) {
        const double first = world.energy().total();
        for (int i = 0; i < seconds * hz; ++i) {
            ASSERT_TRUE(world.step(1.0 / hz)) << i;
            const double gain = (world.energy().total() - first) / scale;
            low = smaller(low, gain), high = larger(high, gain);
            separation = larger(separation, world.errors().separation);
        }
    }
};

void expectKept(World& world, double seconds, double scale) {
    EnergyRange swing;
    swing.run(world, seconds, scale);
    EXPECT_LT(swing.high, 0.005);
    EXPECT_GT(swing.low, -0.05);
    EXPECT_LT(swing.separation, 1e-6);
}

/// `links` of half a metre, level, the first on a hook; `scale` is the energy they lose until they hang.
World levelChain(int links, JointType type, const Settings& settings, double& scale) {
    World world(settings);
    BodyId last = world.add(support::hook());
    scale = 0.0;
    for (int i = 0; i < links; ++i) {
        const bool rods = type == JointType::distance;
        const double middle = 0.5 * i + (rods ? 0.5 : 0.25);
        BodyDef link = body(rods ? Shape::sphere(0.05) : Shape::box({0.5, 0.1, 0.1}),
                            {middle, 0, 0});
        link.collide = false;
        const BodyId next = world.add(link);
        if (rods) support::rod(world, last, next);
        else support::join(world, type, last, next, {0.5 * i, 0, 0});
        last = next;
        scale += support::kGravity * middle;
    }
    return world;
}

struct Links {
    int links;
    JointType type;
    double seconds;
};

class LevelChain : public testing::TestWithParam<Links> {};
INSTANTIATE_TEST_SUITE_P(
    Mechanisms, LevelChain,
    testing::Values(Links{1, JointType::ball, 600}, Links{2, JointType::ball, 600},
                    Links{3, JointType::hinge, 600}, Links{5, JointType::ball, 120},
                    Links{5, JointType::hinge, 120}, Links{5, JointType::distance, 120},
                    Links{30, JointType::ball, 20}, Links{100, JointType::ball, 5}),
    [](const auto& one) {
        return std::to_string(one.param.links) + "Type" +
               std::to_string(static_cast<int>(one.param.type));
    });

TEST_P(LevelChain, NeverGainsEnergyAndLosesLittle) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        double scale = 0.0;
        World world = levelChain(GetParam().links, GetParam().type, settings, scale);
        expectKept(world, GetParam().seconds, scale);
    }
}

/// Links of 0.2 to 0.8 m and 0.3 to 3 kg in any direction, with joints of the given types about any axis.
World chainInAnyPose(int links, std::span<const JointType> types, std::uint64_t seed,
                     const Settings& settings, double& scale) {
    World world(settings);
    support::Random random(seed);
    BodyId last = world.add(support::hook());
    Vec3 at = Vec3::Zero();
    scale = 0.0;
    double reach = 0.0;
    for (int i = 0; i < links; ++i) {
        const double length = random.number(0.2, 0.8), mass = std::pow(10.0, random.number(-0.5, 0.5));
        const Vec3 along = length * (Vec3(0, 0.4, 0) + random.vector(1)).normalized();
        BodyDef link = body(Shape::box({length, 0.1, 0.08}), at + 0.5 * along, mass);
        link.pose.rotation = Quat::FromTwoVectors(Vec3(Vec3::UnitX()), Vec3(along.normalized()));
        link.collide = false;
        const BodyId next = world.add(link);
        const JointType type = types[std::size_t(random.number(0, double(types.size())))];
        const Vec3 pin = random.vector(1).normalized();
        const Vec3 other = type == JointType::universal ? Vec3(pin.unitOrthogonal()) : pin;
        world.add(support::jointAt(world, type, last, next, at, pin, other));
        last = next, at += along, reach += length;
        scale += mass * support::kGravity * (reach - 0.5 * length);
    }
    return world;
}

// A short link among long ones whips: its spin triples within a step.
TEST(ChainsInAnyPose, NeverGainEnergyAndLoseLittle) {
    using enum JointType;
    const std::vector<JointType> kinds[] = {
        {ball, hinge}, {universal}, {ball, hinge, universal, constantVelocity}};
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const int links : {1, 5})
            for (int kind = 0; kind < 3; ++kind) {
                SCOPED_TRACE(testing::Message() << links << " links, kind " << kind);
                double scale = 0.0;
                World world = chainInAnyPose(links, kinds[kind], 30 + links, settings, scale);
                expectKept(world, 12, scale);
            }
}

TEST(ChainAt240Hz, LosesLessThanAPercent) {
    double scale = 0.0;
    World world = levelChain(5, JointType::ball, Settings::steady(), scale);
    EnergyRange swing;
    swing.run(world, 60, scale, 240.0);
    EXPECT_LT(swing.high, 0.001);
    EXPECT_GT(swing.low, -0.01);
}

// Parallel hinges constrain a loop of four bars three times too often.
TEST(FourBars, KeepTheirEnergyInALoop) {
    for (const JointType type : {JointType::hinge, JointType::ball}) {
        World world;
        const Vec3 corners[] = {{0, 0, 0}, {0.3, 0.4, 0}, {1.1, 0.6, 0}, {1, 0, 0}};
        BodyId last = world.add(support::hook(corners[0]));
        for (int i = 0; i < 3; ++i) {
            const Vec3 along = corners[i + 1] - corners[i];
            BodyDef bar = body(Shape::box({along.norm(), 0.1, 0.08}), corners[i] + 0.5 * along);
            bar.pose.rotation = support::turnInPlane(along);
            bar.collide = false;
            const BodyId next = world.add(bar);
            support::join(world, type, last, next, corners[i]);
            last = next;
        }
        support::join(world, type, last, world.add(support::hook(corners[3])), corners[3]);
        EnergyRange swing;
        swing.run(world, 120, 3 * support::kGravity * 0.5);
        EXPECT_LT(swing.high, 0.005);
        EXPECT_GT(swing.low, -0.05);
    }
}

BodyId addBar(World& world, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    BodyDef bar = body(Shape::box({along.norm(), 0.1, 0.08}), from + 0.5 * along);
    bar.pose.rotation = support::turnInPlane(along);
    bar.collide = false;
    return world.add(bar);
}

/// A regular ring of links of half a metre, joined at its corners.
World linkRing(int links, JointType type, const Settings& settings) {
    World world(settings);
    const double radius = 0.25 / std::sin(M_PI / links);
    const auto corner = [&](int i) {
        const double angle = 2.0 * M_PI * i / links + 0.1;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    };
    for (int i = 0; i < links; ++i) addBar(world, corner(i), corner(i + 1));
    for (int i = 0; i < links; ++i)
        support::join(world, type, {(i + links - 1) % links}, {i}, corner(i));
    return world;
}

/// Spheres that do not collide, a metre apart, joined in the middle between neighbours; one edge is held.
World sheet(int n, const Settings& settings) {
    World world(settings);
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i) {
            BodyDef ball = support::body(Shape::sphere(0.4), Vec3(k, 0, i));
            ball.groups = ball.ignores = 1;
            if (i == 0) ball.kind = BodyKind::fixed;
            const int id = world.add(ball).index;
            if (i == 0) continue;
            support::join(world, JointType::ball, {id - 1}, {id}, Vec3(k, 0, i - 0.5));
            if (k > 0) support::join(world, JointType::ball, {id - n}, {id}, Vec3(k - 0.5, 0, i));
        }
    return world;
}

// When it folds, rows of its loops nearly depend on each other.
TEST(Sheets, NeverGainEnergyWhenTheyFold) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world = sheet(12, settings);
        const double scale = 132 * world.mass({143}) * 9.81 * 5.5;  // J, m g h; it begins with 0
        for (int step = 0; step < 1200; ++step) {
            world.step(support::kStep);
            ASSERT_LT(world.energy().total(), 0.005 * scale) << step;
        }
        EXPECT_EQ(world.report().trouble, Trouble::none);
        EXPECT_TRUE(world.has({143}));
    }
}

// No body of the loop is fixed: the joint that closes it is solved with the others.
TEST(Rings, KeepTheirEnergyInFreeFlight) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const JointType type : {JointType::hinge, JointType::ball})
            for (const int links : {3, 4, 6, 12}) {
                World world = linkRing(links, type, settings);
                world.setGravity(Vec3::Zero());
                for (int i = 0; i < links; ++i) {  // it deforms while it turns
                    const Vec3 spin(0.5, 0.1, 2), at = world.pose({i}).position;
                    world.setVelocity({i}, spin.cross(at) + Vec3(0.3 * at.y(), 0, 0), spin);
                }
                world.step(support::kStep);  // the velocities fit the joints
                SCOPED_TRACE(links);
                expectKept(world, 60, world.energy().kinetic);
            }
}

TEST(Rings, KeepTheirEnergyHangingOnOneLink) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world = linkRing(5, JointType::ball, settings);
        const Vec3 at = world.pose({0}).position + Vec3(0.1, 0.1, 0);
        support::join(world, JointType::ball, world.add(support::hook(at)), {0}, at);
        expectKept(world, 60, 5 * support::kGravity * 0.43);
    }
}

// Six squares of rods with a diagonal each, on one corner: six loops in one tree.
TEST(Trusses, KeepTheirEnergySwinging) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        constexpr int kSquares = 6;
        for (int i = 0; i <= kSquares; ++i)
            for (const double y : {0.0, 1.0}) {
                BodyDef knot = body(Shape::sphere(0.1), {1.0 * i, y, 0});
                knot.collide = false;
                world.add(knot);
            }
        for (int i = 0; i <= kSquares; ++i) {
            support::rod(world, {2 * i}, {2 * i + 1});
            if (i == kSquares) break;
            support::rod(world, {2 * i}, {2 * i + 2});
            support::rod(world, {2 * i + 1}, {2 * i + 3});
            support::rod(world, {2 * i}, {2 * i + 3});
        }
        const BodyId hook = world.add(support::hook());
        support::join(world, JointType::ball, hook, {0}, Vec3::Zero());
        expectKept(world, 60, 14 * support::kGravity * 3);
    }
}

TEST(ConstantVelocityJoints, KeepTheirEnergyInAChain) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        BodyId last = world.add(support::hook());
        for (int i = 0; i < 5; ++i) {
            const Vec3 at(0.5 * i, 0, 0);
            const BodyId next = addBar(world, at, at + Vec3(0.5, 0, 0));
            support::join(world, JointType::constantVelocity, last, next, at, Vec3::UnitX());
            last = next;
        }
        expectKept(world, 60, 5 * support::kGravity * 1.25);
    }
}

/// A bar on a hook, lifted by `lift` (rad) and turned about the vertical with 2 rad/s, for half a minute.
EnergyRange wildBar(JointDef joint, double lift, const Settings& settings) {
    World world(settings);
    const Vec3 along(std::cos(lift), std::sin(lift), 0);
    joint.a = world.add(support::hook()), joint.b = addBar(world, Vec3::Zero(), 0.5 * along);
    joint.anchorB = world.pose(joint.b).rotation.conjugate() * Vec3(-0.25 * along);
    joint.axis = along, joint.axis2 = Vec3::UnitZ();
    const Vec3 spin(0, 2.0, 0);
    world.setVelocity(joint.b, spin.cross(Vec3(0.25 * along)), spin);
    world.add(joint);
    EnergyRange range;
    range.run(world, 30, support::kGravity * 0.25 * (1 + std::abs(along.y())) + world.energy().kinetic);
    return range;
}

// Where the shafts point against each other the twist is undefined, but not the joint.
TEST(ConstantVelocityJoints, KeepTheEnergyOfABarThatSwingsOver) {
    JointDef twistFree;
    twistFree.type = JointType::sixDof;
    for (const int i : {0, 1, 2, 3}) twistFree.free[i].locked = true;
    JointDef shafts;
    shafts.type = JointType::constantVelocity;
    for (const Settings& settings : {Settings::steady(), Settings::fast()})
        for (const double lift : {0.0, 1.0, 2.5})
            for (const JointDef& joint : {shafts, twistFree}) {
                const EnergyRange range = wildBar(joint, lift, settings);
                EXPECT_LT(range.high, 0.005) << lift;
                EXPECT_GT(range.low, -0.02) << lift;
                EXPECT_LT(range.separation, 1e-4) << lift;
            }
}

// Two bars and a block on a rail: the slider closes the loop.
TEST(SliderCrank, KeepsItsEnergy) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        const Vec3 pin(0.3, 0.3, 0), end(1.2, 0, 0);
        const BodyId hook = world.add(support::hook());
        const BodyId crank = addBar(world, Vec3::Zero(), pin), rod = addBar(world, pin, end);
        BodyDef block = body(Shape::box({0.2, 0.2, 0.2}), end);
        block.collide = false;
        const BodyId slide = world.add(block);
        support::join(world, JointType::hinge, hook, crank, Vec3::Zero());
        support::join(world, JointType::hinge, crank, rod, pin);
        support::join(world, JointType::hinge, rod, slide, end);
        support::join(world, JointType::slider, hook, slide, end, Vec3::UnitX());
        expectKept(world, 120, 2 * support::kGravity * 0.5);
    }
}

// A pendulum on a block on a rail, and one on the block of another slider that is carried along.
TEST(Sliders, KeepTheirEnergyInAChain) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        const BodyId hook = world.add(support::hook());
        const BodyId cart = addBar(world, Vec3::Zero(), {0.5, 0, 0});
        const BodyId arm = addBar(world, {0.5, 0, 0}, {1.0, 0, 0});
        const BodyId bead = addBar(world, {0.9, -0.1, 0}, {0.9, 0.1, 0});
        support::join(world, JointType::slider, hook, cart, Vec3::Zero(), Vec3::UnitX());
        support::join(world, JointType::hinge, cart, arm, {0.5, 0, 0});
        support::join(world, JointType::slider, arm, bead, {0.9, 0, 0}, Vec3(1, 0.2, 0).normalized());
        expectKept(world, 20, 2 * support::kGravity);
    }
}

TEST(UniversalJoints, KeepTheirEnergyInAChain) {
    for (const Settings& settings : {Settings::steady(), Settings::fast()}) {
        World world(settings);
        BodyId last = world.add(support::hook());
        for (int i = 0; i < 4; ++i) {
            const Vec3 at(0.5 * i, 0, 0);
            const BodyId next = addBar(world, at, at + Vec3(0.5, 0, 0));
            JointDef def;
            def.type = JointType::universal;
            def.a = last, def.b = next;
            def.axis = Vec3::UnitZ(), def.axis2 = Vec3::UnitY();
            def.anchorA = world.pose(last).toLocal(at), def.anchorB = world.pose(next).toLocal(at);
            world.add(def);
            last = next;
        }
        expectKept(world, 120, 4 * support::kGravity);
    }
}

}  // namespace
}  // namespace engine
