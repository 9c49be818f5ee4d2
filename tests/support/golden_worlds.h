/// Worlds whose state after some seconds is known to the last bit.
#pragma once
#include <array>

#include "engine/base/trigonometry.h"
#include "tests/support/joints.h"

namespace support {

struct GoldenWorld {
    const char* name;
    World (*make)();
    int steps;
    std::uint64_t hash;
};

/// Ten boxes, each a little turned, and a heavy ball that falls on them.
inline World goldenStack() {
    World world = stack(10);
    for (int i = 1; i <= 10; ++i)
        world.setPose({i}, {{0.01 * (i % 3), i - 0.5, 0},
                            engine::turnAboutXyz({0, engine::radians(7.0 * i), 0})});
    world.add(body(Shape::sphere(0.5), {0.2, 12.0, 0.1}, 4000.0));
    return world;
}

/// A rod, let go at the level.
inline World goldenPendulum() {
    World world;
    const BodyId top = world.add(hook()), bob = world.add(body(Shape::sphere(0.1), {1, 0, 0}));
    rod(world, top, bob);
    return world;
}

/// Forty links and a ball of a hundred times their weight, let go at the level, a floor below.
inline World goldenChain() {
    World world;
    BodyId last = world.add(hook({0, 15, 0}));
    for (int i = 0; i < 40; ++i) {
        BodyDef link = body(Shape::capsule(0.08, 0.5), {0.4 * i + 0.2, 15, 0}, 1.0);
        link.pose.rotation = engine::turnAboutXyz({0, 0, engine::radians(90)});
        const BodyId next = world.add(link);
        join(world, JointType::ball, last, next, {0.4 * i, 15, 0});
        last = next;
    }
    const BodyId ball = world.add(body(Shape::sphere(0.6), {16.6, 15, 0}, 100.0));
    join(world, JointType::ball, last, ball, {16.0, 15, 0});
    world.add(floorPlane());
    return world;
}

/// A pyramid large enough to be shared by threads (wide/overlap.h), and a ball that breaks into it.
inline World goldenPyramid() {
    World world;
    world.add(floorPlane());
    constexpr int kBase = 30;
    for (int row = 0; row < kBase; ++row)
        for (int i = row; i < kBase; ++i)
            world.add(body(Shape::box({1, 1, 1}), {1.02 * i - 0.51 * row, 0.5 + row, 0}));
    BodyDef ball = body(Shape::sphere(1.0), {-3.0, 4.0, 0.1}, 20.0);
    ball.velocity = Vec3(25.0, 3.0, 0);
    world.add(ball);
    return world;
}

/// A joint of every type, with limits, motors and springs, on a load that swings.
inline World goldenMachine() {
    World world;
    const BodyId hook = world.add(support::hook());
    for (int i = 0; i < 13; ++i) {
        const double x = 3.0 * i;
        BodyDef def = body(Shape::box({0.6, 0.3, 0.4}), {x, 0, 0}, 2.0 + i);
        def.spin = {0.3, 0.2 * i, 1.0};
        const BodyId box = world.add(def), load = world.add(body(Shape::sphere(0.2), {x, -1, 0.3}));
        JointDef joint = jointAt(world, static_cast<JointType>(i), hook, box, {x + 0.1, 0.4, 0},
                                 {0, 0, 1}, {0, 1, 0});
        joint.length = 0.5;
        if (joint.type == JointType::distance) joint.anchorA += Vec3(0, 0.5, 0);
        if (joint.type == JointType::lookAt) joint.anchorA = {x, 2, 1};
        if (joint.type == JointType::path)
            joint.path = {{x - 1, 0.2, 0}, {x, 0.4, 0.3}, {x + 1, 0.5, 0}, {x + 2, 0, 0}};
        if (joint.type == JointType::hinge) joint.free[0].limits = {-1.0, 0.5};
        if (joint.type == JointType::slider) joint.free[0].motor = {0.3, 40.0};
        if (joint.type == JointType::ball) joint.free[1].limits.high = 0.4;
        if (joint.type == JointType::wheel) joint.free[0].spring = {1.5, 0.3};
        if (joint.type == JointType::sixDof) joint.free[0].locked = joint.free[4].locked = true;
        world.add(joint);
        join(world, JointType::ball, box, load, {x, -0.3, 0.1});
    }
    return world;
}

inline const std::array<GoldenWorld, 4>& goldenWorlds() {
    static const std::array<GoldenWorld, 4> worlds{{
        {"stack", goldenStack, 300, 0x47c791b2da072290},
        {"pendulum", goldenPendulum, 600, 0xfebf4f2b0b5692e9},
        {"chain", goldenChain, 300, 0x7090f3317d0edf6e},
        {"pyramid", goldenPyramid, 60, 0x52d5cd5112539786},
    }};
    return worlds;
}

}  // namespace support
