/// A collision constraint as it persists: rebuilt after every step from the shapes, its impulses
/// carried over by feature. What a solver computes from it is in contact_constraint.h.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

struct ContactPoint {
    Vec3 anchorA = Vec3::Zero(), anchorB = Vec3::Zero();  // m, body axes, on either surface
    int feature = 0;
    double impulse = 0.0;           // N s along the normal, of one sub-step
    Vec3 friction = Vec3::Zero();   // N s on b, of one sub-step
};

struct Contact {
    static constexpr int kMaxPoints = 4;
    int a = -1, b = -1;             // body numbers, a < b
    Vec3 normal = Vec3::UnitY();    // unit, from a to b
    double friction = 0.0;          // mu of the two surfaces together
    double restitution = 0.0;       // e of the two surfaces together
    double rolling = 0.0;           // rho of the two surfaces together, m
    Vec3 rollingMoment = Vec3::Zero();  // N m s on b, of one sub-step
    double depth = 1e9;             // m, how far down it is for the order of a sweep; not yet known
    Vec3 normalA = Vec3::UnitY();   // the normal in a's axes, and b as seen from a, when it was found
    Pose seenFromA{Vec3::Constant(1e9), Quat::Identity()};
    int count = 0;
    std::array<ContactPoint, kMaxPoints> points;
};

/// Rows are made once a step; of a body that has turned by more since (rad), M^-1 is that of now. Rows of
/// a contact and of joints that took different M^-1 for one body would not converge, but diverge.
constexpr double kFarTurn = 0.1, kFarTurnOfJointed = 1e-3;

}  // namespace engine
