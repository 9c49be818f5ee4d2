/// A joint as it is given to a World, and as it is read from one.
#pragma once
#include <compare>

#include "engine/base/math.h"
#include "engine/body.h"

namespace engine {

/// ball: a point in common, 3 rows. distance: two points at a fixed distance (a rod), 1 row.
/// hinge: a point and an axis in common, 5 rows. weld: no relative motion, 6 rows.
enum class JointType { ball, distance, hinge, weld };

/// A joint's number in its world, as BodyId is a body's.
struct JointId {
    int index = -1;  // -1: none
    auto operator<=>(const JointId&) const = default;
};

/// Makes a joint soft (constraints/soft.h).
struct Spring {
    double hz = 0.0;       // frequency of the masses it joins, along a row; 0: rigid
    double damping = 0.0;  // ratio: 0 swings on, 1 just does not overshoot
    bool isSoft() const { return hz > 0.0; }  // otherwise rigid
};

/// Everything about a joint that is given to World::add, which says what has to hold.
struct JointDef {
    JointType type = JointType::ball;
    BodyId a, b;                 // two bodies, one of them dynamic
    Vec3 anchorA{0, 0, 0};       // m, in a's body axes from its centre of mass
    Vec3 anchorB{0, 0, 0};       // m, in b's
    Vec3 axis{0, 0, 1};          // hinge: world axes, at the moment of adding, any length
    double length = 0.0;         // m, distance joint; must be positive
    Spring spring;               // of all its rows
};

/// A joint as the last step left it.
struct JointState {
    JointDef def;
    Vec3 worldA, worldB;         // m, the two anchors
    double separation = 0.0;     // m: |C| of the rows in metres
    Vec3 force{0, 0, 0};         // N, on b, mean over the last step
    Vec3 torque{0, 0, 0};        // N m, on b about its anchor, mean over the last step
    bool removed = false;        // by the caller, or with one of its bodies
};

}  // namespace engine
