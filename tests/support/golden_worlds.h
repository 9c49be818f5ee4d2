/// Worlds whose state after some seconds is known to the last bit.
#pragma once
#include <array>

#include "engine/base/trigonometry.h"
#include "tests/support/worlds.h"

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
