/// A persistent collision constraint: rebuilt from the shapes after every step, with impulses carried over by
/// feature. contact_constraint.h has what solvers compute from it.
#pragma once
#include <array>

#include "engine/base/math.h"

namespace engine {

struct ContactPoint {
    Vec3 anchorA = Vec3::Zero(), anchorB = Vec3::Zero();  // m, body axes, on the two surfaces
    int feature = 0;
    double impulse = 0.0;           // N s along the normal, of one sub-step
    Vec3 friction = Vec3::Zero();   // N s on b, of one sub-step
};

struct Contact {
    static constexpr int kMaxPoints = 4;
    int a = -1, b = -1;             // body numbers, a < b
    Vec3 normal = Vec3::UnitY();    // unit, from a to b
    /// m, across the normal: from the arms of the points to those that the bodies will have when they meet.
    Vec3 slideA = Vec3::Zero(), slideB = Vec3::Zero();
    double friction = 0.0;          // mu, combined
    double restitution = 0.0;       // e, combined
    double rolling = 0.0;           // rho, combined, m
    Vec3 rollingMoment = Vec3::Zero();  // N m s on b, of one sub-step
    double depth = 1e9;             // m, depth for the order of a sweep; default: unknown
    Vec3 normalA = Vec3::UnitY();   // when it was found: the normal in a's axes, and b's pose in them
    Pose seenFromA{Vec3::Constant(1e9), Quat::Identity()};
    int count = 0;
    std::array<ContactPoint, kMaxPoints> points;
};

/// Rows are made once per step; for a body that has turned more than this since (rad), M^-1 is updated. If
/// rows of contacts and joints used different M^-1 for one body, the solver would diverge.
constexpr double kFarTurn = 0.1, kFarTurnOfJointed = 1e-3;

}  // namespace engine
