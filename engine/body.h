/// A rigid body as it is given to a World, and as it is read from one.
#pragma once
#include <optional>

#include "engine/base/math.h"
#include "engine/material.h"
#include "engine/shape.h"

namespace engine {

/// dynamic: moved by forces and impulses. fixed: never moves, to the bit (a static body; the word
/// is taken by the language). kinematic: moves as prescribed by its velocity, whatever hits it.
enum class BodyKind { dynamic, fixed, kinematic };

/// A body of a world. Numbers are 0, 1, 2 ... in the order of adding; that of a removed body is used
/// again after the next step, with another generation: an id never names a second body.
struct BodyId {
    int index = -1;  // -1: none
    unsigned generation = 0;  // how often the number was used before
    auto operator<=>(const BodyId&) const = default;
};

/// What acts on a body besides gravity, about its centre of mass, world axes.
struct Load {
    Vec3 force = Vec3::Zero();   // N
    Vec3 torque = Vec3::Zero();  // N m
};

/// Everything about a body that is given to World::add, which says what has to hold.
struct BodyDef {
    BodyKind kind = BodyKind::dynamic;
    Shape shape;
    Material material;
    Pose pose;
    Vec3 velocity{0, 0, 0};       // m/s, of the centre of mass
    Vec3 spin{0, 0, 0};           // rad/s, world axes
    std::optional<double> mass;   // kg; else density times the shape's volume
    std::optional<Mat3> inertia;  // kg m^2, body axes, one that a body has; else the
                                  // shape's own, scaled to the mass
    bool collide = true;          // false: passes through everything
    bool sensor = false;          // true: passes through everything too, but tells of whom it
                                  // overlaps (World::touches)
    unsigned groups = 0;          // a bit for each group that it belongs to
    unsigned ignores = 0;         // groups whose bodies it passes through, and they through it
};

}  // namespace engine
