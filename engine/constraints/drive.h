/// What acts along the coordinates x that a joint leaves free, dx/dt = J v. Up to three rows each:
///   spring   C = x - rest, soft (soft.h)
///   motor    J v - speed = 0,                 |lambda| <= strength h
///   limit    C = s (x - bound) >= 0 and s J for the nearer bound, s = 1 for the low one, -1 for the
///            high one:  s J v + b >= 0, lambda >= 0, with b = C / h, so that it may be reached in
///            this sub-step and not passed; for C < 0 see setBiases. Two equal bounds: an equality.
/// In every sweep the total is clamped to its bounds [low, high], like a contact's.
///
/// An impulse along J alone would tear at the rows J_r that the joint holds, and the sweep would go back
/// and forth between the two (with a small bob on a long arm a thousand times). So J is freed first:
///   J <- J - (J M^-1 J_r^T) (J_r M^-1 J_r^T)^-1 J_r
/// which is the same rate where J_r v = 0 and an impulse together with the joint's own reaction: K is
/// then what a motor has to turn, the inertia about the hinge.
#pragma once
#include "engine/constraints/joint_constraint.h"

namespace engine {

enum class DriveKind { spring, motor, limit };

template <class Real>
struct DriveRow {
    DriveKind kind = DriveKind::limit;
    int coordinate = 0;
    Freedom freedom;
    Real sign = Real(1);               // s of a limit
    Real error = Real(0);              // C, m or rad
    Real bias = Real(0);               // b, m/s or rad/s
    Real softness = Real(0);           // of a spring
    Real low = Real(0), high = Real(0);  // bounds of lambda
    Real lambda = Real(0);             // N s (N m s), of one sub-step

    int slot() const { return 3 * coordinate + static_cast<int>(kind); }  // in Joint::driven
};

template <class Real>
struct JointDrive {
    static constexpr int kMaxRows = 18;
    int a = -1, b = -1;
    int joint = -1;                      // its number in the world
    int count = 0;
    std::array<DriveRow<Real>, kMaxRows> rows;
    std::array<Row<Real>, 6> along;      // by coordinate, freed of what the joint holds
    Vec3T<Real> totalImpulse = Vec3T<Real>::Zero();  // N s on b, over the whole step
    Vec3T<Real> totalTwist = Vec3T<Real>::Zero();    // N m s on b about its centre of mass

    /// s J
    Row<Real> rowOf(const DriveRow<Real>& row) const {
        Row<Real> r = along[row.coordinate];
        r.j = {row.sign * r.j.linear, row.sign * r.j.angularA, row.sign * r.j.angularB};
        r.turnA *= row.sign, r.turnB *= row.sign;
        return r;
    }
};

/// Applies an impulse along one row and books it as the joint's reaction.
template <class Real>
void push(JointDrive<Real>& drive, const DriveRow<Real>& row, Real lambda, Velocity<Real>& a,
          Velocity<Real>& b) {
    const Row<Real>& along = drive.along[row.coordinate];
    const Real signedLambda = row.sign * lambda;
    apply(along, signedLambda, a, b);
    drive.totalImpulse += signedLambda * along.j.linear;
    drive.totalTwist += signedLambda * along.j.angularB;
}

/// lambda = -(s J v + b + gamma total) / (K + gamma), the total clamped; gives what was added.
template <class Real>
Real pushWithin(const Row<Real>& along, DriveRow<Real>& row, const Velocity<Real>& a,
                const Velocity<Real>& b) {
    if (!(along.k > Real(0))) return Real(0);
    const Real rate = row.sign * velocityAlong(along.j, a, b);
    const Real before = row.lambda;
    const Real lambda = -(rate + row.bias + row.softness * before) / (along.k + row.softness);
    row.lambda = clamped(before + lambda, row.low, row.high);
    return row.lambda - before;
}

/// The rows of what acts on a joint, springs first and limits last: in a sweep the last one wins.
template <class Real>
JointDrive<Real> driveOf(const JointDef& def) {
    JointDrive<Real> drive;
    drive.a = def.a.index, drive.b = def.b.index;
    for (const DriveKind kind : {DriveKind::spring, DriveKind::motor, DriveKind::limit})
        for (int i = 0; i < 6; ++i) {
            const Freedom& f = def.free[i];
            const bool acts = kind == DriveKind::spring  ? f.spring.isSoft()
                              : kind == DriveKind::motor ? f.motor.isOn()
                                                         : f.limits.any();
            if (!acts) continue;
            DriveRow<Real>& row = drive.rows[drive.count++];
            row.kind = kind;
            row.coordinate = i;
            row.freedom = f;
        }
    return drive;
}

/// C of a row, and the nearer bound of a limit.
template <class Real>
void place(DriveRow<Real>& row, Real x) {
    const Limits& limits = row.freedom.limits;
    if (row.kind == DriveKind::motor) return;
    if (row.kind == DriveKind::spring) {
        row.error = x - static_cast<Real>(row.freedom.rest);
        return;
    }
    const Real low = static_cast<Real>(limits.low), high = static_cast<Real>(limits.high);
    const bool lower = x - low <= high - x || low >= high;
    const Real sign = lower ? Real(1) : Real(-1);
    if (sign != row.sign) row.lambda = Real(0);
    row.sign = sign;
    row.error = sign > Real(0) ? x - low : high - x;
}

/// b, gamma and the bounds of lambda, for a sub-step of length h (s); beta is Baumgarte's.
template <class Real>
void setBias(DriveRow<Real>& row, Real k, Real beta, Real h) {
    constexpr Real kAny = std::numeric_limits<Real>::infinity();
    row.low = -kAny, row.high = kAny;
    if (row.kind == DriveKind::spring) {
        const SoftRow<Real> soft = softRow(row.freedom.spring, k, row.error, h);
        row.softness = soft.softness;
        row.bias = soft.bias;
    } else if (row.kind == DriveKind::motor) {
        row.bias = -static_cast<Real>(row.freedom.motor.speed);
        row.high = static_cast<Real>(row.freedom.motor.strength) * h;
        row.low = -row.high;
    } else {
        const bool held = row.freedom.limits.low >= row.freedom.limits.high;
        if (!held) row.low = Real(0);
        row.bias = (row.error > Real(0) && !held ? Real(1) : beta) * row.error / h;
    }
}

}  // namespace engine
