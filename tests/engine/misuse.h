/// A small world to misuse, and the check that a misuse stops the program.
#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <limits>

#include "engine/world.h"
#include "tests/support/worlds.h"

namespace engine::misuse {

using support::kStep;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = kUnlimited;
inline const Vec3 kNowhere(0, kNan, 0), kEndless(kInf, 0, 0);

/// A floor, a box on it, a ball on a rope, and a force on the box.
struct Scene {
    World world;
    BodyId floor = world.add(support::floorPlane());
    BodyId box = world.add(support::body(Shape::box({1, 1, 1}), {0, 0.5, 0}));
    BodyId ball = world.add(support::body(Shape::sphere(0.1), {3, 2, 0}));
    JointId rope = support::join(world, JointType::ball, floor, ball, {3, 3, 0});
    ForceId push = world.add(ForceDef{ConstantForce{.force = {1, 0, 0}}, {box}});
};

using Misuse = std::function<void(Scene&)>;

inline void stops(const char* advice, std::initializer_list<Misuse> misuses) {
    int number = 0;
    for (const Misuse& misuse : misuses) {
        Scene scene;
        EXPECT_DEATH(misuse(scene), advice) << "number " << number;
        ++number;
    }
}

}  // namespace engine::misuse
