/// Forces on bodies besides gravity, as given to World::add. The equations are in forces/, one file per kind.
#pragma once
#include <limits>
#include <variant>
#include <vector>

#include "engine/body.h"

namespace engine {

/// A force that is constant in world axes, or in the axes of its body (forces/constant_force.h).
struct ConstantForce {
    Vec3 force{0, 0, 0};   // N
    Vec3 torque{0, 0, 0};  // N m
    Vec3 at{0, 0, 0};      // m, body axes: where the force acts
    bool turns = false;    // false: force and torque in world axes; true: in body axes
};

/// Drag proportional to the speed (forces/drag.h).
struct Drag {
    double linear = 0.0;   // c, N s/m
    double angular = 0.0;  // k, N m s
};

/// Air or water, moving or at rest: drag and buoyancy (forces/medium.h).
struct Medium {
    static constexpr double kNoEnd = std::numeric_limits<double>::infinity();  // m
    double density = 1.2;         // rho, kg/m^3
    Vec3 velocity{0, 0, 0};       // m/s: wind, current
    double dragCoefficient = 1.0; // C: 0.5 for a ball, 1 for a cube, 0 for no drag
    bool carries = true;          // buoyancy
    double level = kNoEnd;        // m, height of its surface, opposite to gravity (without gravity: y)
    Vec3 low = Vec3::Constant(-kNoEnd);   // m, world axes: the medium fills the box from low to
    Vec3 high = Vec3::Constant(kNoEnd);   // high; a body is in it when its centre of mass is
};

/// Gravity towards a point (forces/point_gravity.h).
struct PointGravity {
    Vec3 centre{0, 0, 0};    // m
    double strength = 1.0;   // mu = G M, m^3/s^2
    double softening = 0.0;  // s, m
};

/// Gravity between bodies (forces/n_body_gravity.h).
struct NBodyGravity {
    double constant = 6.6743e-11;  // G, m^3/(kg s^2)
    double softening = 0.0;        // s, m: keeps the force finite where bodies meet in a point
};

/// A spring with a damper between points of two bodies (forces/spring_force.h).
struct SpringForce {
    Vec3 anchorA{0, 0, 0}, anchorB{0, 0, 0};  // m, body axes
    double length = 0.0;                      // l, m, at rest
    double stiffness = 1.0;                   // k, N/m
    double damping = 0.0;                     // c, N s/m
};

/// A wing, a fin or a flat plate (forces/airfoil.h).
struct Airfoil {
    static constexpr double kStallWidth = 0.1;  // of sin(alpha), from attached to stalled
    double area = 1.0;            // A, m^2
    Vec3 at{0, 0, 0};             // m, body axes: where the air's force acts
    Vec3 chord{1, 0, 0};          // unit, body axes: forwards, to the leading edge
    Vec3 normal{0, 1, 0};         // unit, body axes, across the chord, towards positive lift
    double density = 1.2;         // rho, kg/m^3
    Vec3 wind{0, 0, 0};           // m/s
    double liftSlope = 6.28318530717958648;  // a
    double stall = 0.26;          // rad
    double profileDrag = 0.02;    // C_0
    double plateDrag = 2.0;       // C_n
    double aspect = 8.0;          // AR, span^2 / area
};

/// Identifies a force of a world, like BodyId a body.
struct ForceId {
    int index = -1;  // -1: none
    unsigned generation = 0;  // how often the number was used before
    auto operator<=>(const ForceId&) const = default;
};

/// Any kind of force.
using ForceKind = std::variant<ConstantForce, Drag, Medium, PointGravity, NBodyGravity,
                               SpringForce, Airfoil>;

/// A force: its kind, its bodies, and its time span. It is evaluated again in every sub-step of its
/// bodies, with the current poses.
struct ForceDef {
    ForceKind kind;
    std::vector<BodyId> on;  // a spring: its two bodies
    double from = 0.0;       // s
    double until = std::numeric_limits<double>::infinity();  // s
};

}  // namespace engine
