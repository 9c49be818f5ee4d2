/// A joint's rows. Every joint type has a file of its own with C and J on top; here is what they
/// share. All rows are equalities: lambda is free.
#pragma once
#include <array>

#include "engine/constraints/soft.h"

namespace engine {

/// A joint as it persists in the world.
struct Joint {
    JointDef def;
    Vec3 axisA = Vec3::UnitZ(), axisB = Vec3::UnitZ();  // hinge: the axis in either body's axes
    Quat turnAtStart = Quat::Identity();                // weld: q_a^-1 q_b
    bool present = true;
    std::array<double, 6> lambda{};                     // N s (N m s), of one sub-step
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();   // N, N m on b: see JointState
};

/// Everything a joint's C and J are made of, in world axes.
template <class Real>
struct JointGeometry {
    Vec3T<Real> armA, armB;     // m, from the centres of mass to the anchors
    Vec3T<Real> between;        // m, p_b - p_a
    Vec3T<Real> axisB;          // hinge: its axis, fixed in b
    Vec3T<Real> acrossA[2];     // hinge: two unit vectors across its axis, fixed in a
    QuatT<Real> turnA, turnB;   // rotations of the two bodies
    QuatT<Real> turnAtStart;    // weld
    Real length;                // m, distance
};

template <class Real>
struct JointRows {
    static constexpr int kMaxRows = 6;
    int count = 0;
    std::array<Jacobian<Real>, kMaxRows> j;
    std::array<Real, kMaxRows> error;  // C, m or rad

    void add(const Jacobian<Real>& jacobian, Real c) {
        j[count] = jacobian;
        error[count++] = c;
    }
};

template <class Real>
struct JointConstraint {
    int a = -1, b = -1;
    int count = 0;
    int joint = -1;      // its number in the world
    bool inTree = false; // solved with its tree, not in the sweep
    std::array<Row<Real>, 6> rows;
    std::array<Real, 6> error{}, bias{}, softness{}, lambda{};
    Spring spring;
    bool pointAtOnce = false;  // the first three rows, a point's, are solved as one
    Mat3T<Real> pointMass = Mat3T<Real>::Zero();     // (J M^-1 J^T)^-1 of these three
    Vec3T<Real> totalImpulse = Vec3T<Real>::Zero();  // N s on b, over the whole step
    Vec3T<Real> totalTwist = Vec3T<Real>::Zero();    // N m s on b about its centre of mass
};

/// Applies an impulse along one row and books it as the joint's reaction; `lambda` is the caller's.
template <class Real>
void push(JointConstraint<Real>& joint, int i, Real lambda, Velocity<Real>& a,
          Velocity<Real>& b) {
    apply(joint.rows[i], lambda, a, b);
    joint.totalImpulse += lambda * joint.rows[i].j.linear;
    joint.totalTwist += lambda * joint.rows[i].j.angularB;
}

/// 3 for a ball, 1 for a distance, 5 for a hinge, 6 for a weld.
int rowCount(JointType type);

JointGeometry<double> geometryOf(const Joint& joint, const Pose& a, const Pose& b);

/// C and J of any joint.
template <class Real>
JointRows<Real> rowsOf(JointType type, const JointGeometry<Real>& geometry);

extern template JointRows<float> rowsOf(JointType, const JointGeometry<float>&);
extern template JointRows<double> rowsOf(JointType, const JointGeometry<double>&);

}  // namespace engine
