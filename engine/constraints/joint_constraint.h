/// A joint's rows. Every joint type has a file of its own with C and J on top; here is what they
/// share. All rows are equalities: lambda is free. What acts along the coordinates that they leave
/// free is in drive.h.
#pragma once
#include <array>

#include "engine/constraints/soft.h"
#include "engine/constraints/turning.h"

namespace engine {

/// A joint as it persists in the world.
struct Joint {
    JointDef def;
    Vec3 axisA = Vec3::UnitZ(), axisB = Vec3::UnitZ();    // `axis` in either body's axes
    Quat turnAtStart = Quat::Identity();                  // q_a^-1 q_b, of the straight joint
    Vec3 axis2A = Vec3::UnitX(), axis2B = Vec3::UnitX();  // axis2 in either body's axes
    Quat startA = Quat::Identity(), startB = Quat::Identity();  // gear: rotations at first
    std::vector<double> lengths;                          // path: m, from its start to every point
    double nearest = 0.0;                                 // path: parameter of the nearest point
    bool present = true, broken = false;
    bool torn = false;                                    // by what cannot all hold
    bool acts = false;                                    // something does along a coordinate
    std::array<double, 6> position{};                     // of the coordinates, to count turns by
    std::array<double, 6> lambda{};                       // N s (N m s), of one sub-step
    std::array<double, 18> driven{};                      // likewise of the coordinates (drive.h)
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

    // From here on only of the types after weld, and for coordinates.
    Vec3T<Real> axisA, axis2A, axis2B;           // fixed in a, a, b
    Vec3T<Real> across2A[2], acrossB[2];         // across axis2A, axisB
    std::array<Real, 6> near{};                  // the coordinates not long ago
    unsigned locked = 0;                         // sixDof: a bit for every coordinate
    Real ratio = Real(1);                        // gear
    Vec3T<Real> startAxisA, startAxisB;          // gear: axisA and axis2B at first,
    QuatT<Real> sinceStartA, sinceStartB;        // and q q_0^-1
    Vec3T<Real> armToB, fromPath;                // path: p_b - x_a, p_b - p(s)
    Vec3T<Real> alongPath, acrossPath[2];
    Real wayOnPath = Real(0);                    // m
};

/// What b has turned as seen from a, in world axes.
template <class Real>
QuatT<Real> turnSinceStart(const JointGeometry<Real>& g) {
    return g.turnB * (g.turnA * g.turnAtStart).conjugate();
}

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

/// The row of an angle; `sign` is that of its rate.
template <class Real>
void addTurn(const Angle<Real>& angle, JointRows<Real>& rows, Real sign = Real(1)) {
    rows.add({Vec3T<Real>::Zero(), Vec3T<Real>(-sign * angle.rate), Vec3T<Real>(sign * angle.rate)},
             angle.value);
}

template <class Real>
struct JointConstraint {
    int a = -1, b = -1;
    int count = 0;
    int joint = -1;      // its number in the world
    bool inTree = false; // solved with its tree, not in the sweep
    bool torn = false;   // see Joint
    std::array<Row<Real>, 6> rows;
    std::array<Real, 6> error{}, bias{}, softness{}, lambda{};
    Spring spring;
    bool pointAtOnce = false;  // the first three rows, a point's, are solved as one
    Mat3T<Real> pointMass = Mat3T<Real>::Zero();     // (J M^-1 J^T)^-1 of these three
    bool asBlock = false;      // a type after weld: where points are blocks, it is one as a whole,
                               // and no part of a tree
    bool allAtOnce = false;    // and is solved so
    Eigen::Matrix<Real, 6, 6> mass = Eigen::Matrix<Real, 6, 6>::Zero();  // likewise of all
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

/// How many rows hold: 3 of a ball, 1 of a distance, 5 of a hinge, 6 of a weld ...
int rowCount(JointType type);
/// The same where it depends on more: none of a distance that is free, what a sixDof locks.
int rowCount(const JointDef& def);

JointGeometry<double> geometryOf(const Joint& joint, const Pose& a, const Pose& b);

/// C and J of any joint.
template <class Real>
JointRows<Real> rowsOf(JointType type, const JointGeometry<Real>& geometry);

extern template JointRows<float> rowsOf(JointType, const JointGeometry<float>&);
extern template JointRows<double> rowsOf(JointType, const JointGeometry<double>&);

/// The coordinates that a joint leaves free, and how they change with the velocities: x and J.
JointRows<double> coordinatesOf(const Joint& joint, const Pose& a, const Pose& b);

/// Keeps in mind where the coordinates are. To be called before any has gone on by half a turn.
void followCoordinates(Joint& joint, const Pose& a, const Pose& b);

}  // namespace engine
