/// Worlds whose state after some seconds is fixed to the last bit.
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

/// Ten boxes, each slightly rotated, and a heavy ball that falls on them.
inline World goldenStack() {
    World world = stack(10);
    for (int i = 1; i <= 10; ++i)
        world.setPose({i}, {{0.01 * (i % 3), i - 0.5, 0},
                            engine::turnAboutXyz({0, engine::radians(7.0 * i), 0})});
    world.add(body(Shape::sphere(0.5), {0.2, 12.0, 0.1}, 4000.0));
    return world;
}

/// A rod, released level.
inline World goldenPendulum() {
    World world;
    const BodyId top = world.add(hook()), bob = world.add(body(Shape::sphere(0.1), {1, 0, 0}));
    rod(world, top, bob);
    return world;
}

/// Forty links and a ball a hundred times as heavy as a link, released level above a floor.
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

/// A pyramid large enough to be shared by threads (wide/overlap.h), hit by a ball.
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

/// One force of every type on bodies of several shapes, half in water; a sensor, an ignored group.
inline World goldenForces() {
    World world;
    BodyDef ground = floorPlane();
    ground.groups = 1u;
    world.add(ground);
    std::vector<BodyId> all;
    for (int i = 0; i < 12; ++i) {
        const Shape shapes[3] = {Shape::box({0.8, 0.5, 0.6}), Shape::sphere(0.3),
                                 Shape::capsule(0.2, 0.9)};
        BodyDef def = body(shapes[i % 3], {0.9 * i - 5.0, 2.0 + 0.3 * (i % 4), 0.1 * i}, 40.0);
        def.spin = {0.3 * i, 1.0, -0.2 * i};
        def.ignores = i == 11 ? 1u : 0u;
        all.push_back(world.add(def));
    }
    BodyDef gate = fixed(Shape::box({4, 4, 4}), {0, 1, 0});
    gate.sensor = true;
    world.add(gate);
    using namespace engine;
    world.add(ForceDef{Medium{.density = 900, .velocity = {0.5, 0, 0}, .level = 1.5}, all});
    world.add(ForceDef{Drag{5.0, 1.0}, all});
    world.add(ForceDef{NBodyGravity{1e-3, 0.1}, all});
    world.add(ForceDef{PointGravity{{0, 3, 0}, 5.0, 0.2}, {all[0], all[1]}});
    world.add(ForceDef{SpringForce{{0.2, 0, 0}, {0, 0.1, 0}, 1.0, 900.0, 20.0}, {all[2], all[5]}});
    const ConstantForce thrust{{60, 0, 0}, {0, 3, 0}, {0, 0.1, 0}, true};
    world.add(ForceDef{thrust, {all[3]}, 0.5, 3.0});
    const Airfoil foil{.area = 2.0, .at = {-0.3, 0, 0}, .wind = {-9, 2, 0}};
    world.add(ForceDef{foil, {all[6], all[9]}});
    world.watchTouches(true);
    return world;
}

/// A joint of every type, with limits, motors and springs, on a load that swings.
inline World goldenMachineThat(bool collides) {
    World world;
    const BodyId hook = world.add(support::hook());
    for (int i = 0; i < 13; ++i) {
        const double x = 3.0 * i;
        BodyDef def = body(Shape::box({0.6, 0.3, 0.4}), {x, 0, 0}, 2.0 + i);
        def.spin = {0.3, 0.2 * i, 1.0};
        BodyDef ball = body(Shape::sphere(0.2), {x, -1, 0.3});
        def.collide = ball.collide = collides;
        const BodyId box = world.add(def), load = world.add(ball);
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

inline World goldenMachine() { return goldenMachineThat(true); }

/// Cylinders, cones, hulls and compounds on hills of triangles.
inline World goldenShapes() {
    World world;
    Random random(3);
    std::vector<double> heights;
    for (int i = 0; i < 121; ++i) heights.push_back(random.number(0.0, 0.5));
    world.add(fixed(Shape::heightField(11, 11, 0.8, heights)));
    const Vec3 corners[] = {{0, 0, 0}, {0.6, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0.4, 0.4}};
    const engine::ShapePart parts[] = {
        {Shape::box({0.6, 0.1, 0.4}), {{0, 0, 0}, Quat::Identity()}},
        {Shape::cylinder(0.1, 0.4), {{0.2, 0.25, 0}, Quat::Identity()}}};
    const Shape shapes[] = {Shape::cylinder(0.25, 0.4), Shape::cone(0.3, 0.5),
                            *Shape::hullOf(corners), Shape::compound(parts), Shape::sphere(0.2),
                            Shape::box({0.4, 0.3, 0.5})};
    for (int i = 0; i < 24; ++i) {
        BodyDef def = body(shapes[i % 6], {0.7 * (i % 5) - 1.4, 1.0 + 0.4 * i, 0.3 * (i % 4)}, 5.0);
        def.pose.rotation = random.rotation();
        world.add(def);
    }
    return world;
}

/// Balls, capsules and cylinders that roll down a slope onto a floor, with varied rolling friction.
inline World goldenRolling() {
    World world;
    world.add(floorPlane());
    world.add(fixed(Shape::plane({0.3, 1, 0}), {0, 1, 0}));
    const Shape shapes[] = {Shape::sphere(0.25), Shape::capsule(0.2, 0.7),
                            Shape::cylinder(0.25, 0.5)};
    Random random(5);
    for (int i = 0; i < 30; ++i) {
        BodyDef def = body(shapes[i % 3], {0.8 * (i % 6) - 4.0, 3.5, 0.8 * (i / 6) - 2.0}, 2.0);
        def.pose.rotation = random.rotation();
        def.material.rolling = 0.002 * (i % 5);
        def.material.restitution = i % 2 == 0 ? 0.3 : 0.0;
        world.add(def);
    }
    return world;
}

inline const std::array<GoldenWorld, 8>& goldenWorlds() {
    static const std::array<GoldenWorld, 8> worlds{{
        {"stack", goldenStack, 300, 0x1e72022cd380609a},
        {"pendulum", goldenPendulum, 600, 0x031b0dd67da8295b},
        {"chain", goldenChain, 300, 0xa5b1bea430c3fad6},
        {"pyramid", goldenPyramid, 60, 0x92f6a19dda0fda13},
        {"forces", goldenForces, 300, 0x4d08300dcdb0ace4},
        {"machine", goldenMachine, 300, 0x250d654e4a444e01},
        {"shapes", goldenShapes, 180, 0xa6f2dd1c0e2b19b},
        {"rolling", goldenRolling, 300, 0x41204f6f5b5f9a7b},
    }};
    return worlds;
}

}  // namespace support
