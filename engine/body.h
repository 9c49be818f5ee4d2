/// A rigid body, as given to a World and as read from it.
#pragma once
#include <optional>

#include "engine/base/math.h"
#include "engine/material.h"
#include "engine/shape.h"

namespace engine {

/// dynamic: moved by forces and impulses. fixed: never moves, to the bit (a static body; `static` is a
/// keyword). kinematic: moves with its prescribed velocity, whatever hits it.
enum class BodyKind { dynamic, fixed, kinematic };

/// A body of a world. Bodies are numbered 0, 1, 2 ... in the order of adding. The number of a removed body is
/// used again after the next step, with another generation, so an id never refers to a second body.
struct BodyId {
    int index = -1;  // -1: none
    unsigned generation = 0;  // how often the number was used before
    auto operator<=>(const BodyId&) const = default;
};

/// Force and torque on a body besides gravity, at its centre of mass, in world axes.
struct Load {
    Vec3 force = Vec3::Zero();   // N
    Vec3 torque = Vec3::Zero();  // N m
};

/// Everything that World::add needs to know about a body; the valid values are documented there.
struct BodyDef {
    BodyKind kind = BodyKind::dynamic;
    Shape shape;
    Material material;
    Pose pose;
    Vec3 velocity{0, 0, 0};       // m/s, of the centre of mass
    Vec3 spin{0, 0, 0};           // rad/s, world axes
    std::optional<double> mass;   // kg; default: density times the shape's volume
    std::optional<Mat3> inertia;  // kg m^2, body axes, physically possible; default: the
                                  // shape's own, scaled to the mass
    bool collide = true;          // false: passes through everything
    bool sensor = false;          // true: passes through everything too, but reports what it
                                  // overlaps (World::touches)
    unsigned groups = 0;          // one bit for each group it belongs to
    unsigned ignores = 0;         // groups it does not collide with
};

}  // namespace engine
