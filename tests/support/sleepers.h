/// Worlds in which islands fall asleep, and measures of them.
#pragma once
#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace support {

constexpr double kMass = 1000.0;  // kg, of a box of support::stack
const Shape kCube = Shape::box({1, 1, 1});

inline Settings sleepy(Settings settings = Settings::steady()) {
    settings.sleeping = true;
    return settings;
}

inline int sleepers(const World& world) {
    int count = 0;
    for (int i = 0; i < world.bodyCount(); ++i) count += world.isAsleep({i}) ? 1 : 0;
    return count;
}

/// Boxes 1 to `count` on the floor 0, asleep.
inline World sleepingStack(int count, const Settings& settings = sleepy()) {
    World world = stack(count, settings);
    run(world, 180);
    EXPECT_EQ(sleepers(world), count);
    return world;
}

/// The load on the floor, body 0, in N.
inline double loadOf(const World& world, double dt = kStep) {
    double sum = 0.0;
    for (const engine::ContactState& c : world.contacts())
        if (c.a.index == 0) sum += c.impulse / dt;
    return sum;
}

inline double height(const World& world, BodyId id) { return world.pose(id).position.y(); }

}  // namespace support
