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
struct JointGeometry {
    Vec3 armA, armB;    // m, from the centres of mass to the anchors
    Vec3 between;       // m, p_b - p_a
    Vec3 axisB;         // hinge: its axis, fixed in b
    Vec3 acrossA[2];    // hinge: two unit vectors across its axis, fixed in a
    Quat turnA, turnB;  // rotations of the two bodies
    Quat turnAtStart;   // weld
    double length;      // m, distance

    // From here on only of the types after weld, and for coordinates.
    Vec3 axisA, axis2A, axis2B;                  // fixed in a, a, b
    Vec3 across2A[2], acrossB[2];                // across axis2A, axisB
    std::array<double, 6> near{};                // the coordinates not long ago
    unsigned locked = 0;                         // sixDof: a bit for every coordinate
    double ratio = 1.0;                          // gear
    Vec3 startAxisA, startAxisB;                 // gear: axisA and axis2B at first,
    Quat sinceStartA, sinceStartB;               // and q q_0^-1
    Vec3 armToB, fromPath;                       // path: p_b - x_a, p_b - p(s)
    Vec3 alongPath, acrossPath[2];
    double wayOnPath = 0.0;  // m
};

/// What b has turned as seen from a, in world axes.
inline Quat turnSinceStart(const JointGeometry& g) {
    return g.turnB * (g.turnA * g.turnAtStart).conjugate();
}

struct JointRows {
    static constexpr int kMaxRows = 6;
    int count = 0;
    std::array<Jacobian, kMaxRows> j;
    std::array<double, kMaxRows> error;  // C, m or rad

    void add(const Jacobian& jacobian, double c) {
        j[count] = jacobian;
        error[count++] = c;
    }
};

/// The row of an angle; `sign` is that of its rate.
inline void addTurn(const Angle& angle, JointRows& rows, double sign = 1.0) {
    rows.add({Vec3::Zero(), Vec3(-sign * angle.rate), Vec3(sign * angle.rate)}, angle.value);
}

struct JointConstraint {
    int a = -1, b = -1;
    int count = 0;
    int joint = -1;      // its number in the world
    bool inTree = false; // solved with its tree, not in the sweep
    bool torn = false;   // see Joint
    double kept = 1.0;   // share of the last impulses to start from, in this sub-step
    std::array<Row, 6> rows;
    std::array<double, 6> error{}, bias{}, softness{}, lambda{};
    Spring spring;
    bool pointAtOnce = false;  // the first three rows, a point's, are solved as one
    Mat3 pointMass = Mat3::Zero();  // (J M^-1 J^T)^-1 of these three
    bool asBlock = false;      // a type after weld: where points are blocks, it is one as a whole
    int treeRows = 0;          // places that it takes in a tree (tree_joint.h); 0: it is no part of one
    bool allAtOnce = false;    // and is solved so
    Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();  // likewise of all
    Vec3 totalImpulse = Vec3::Zero();  // N s on b, over the whole step
    Vec3 totalTwist = Vec3::Zero();    // N m s on b about its centre of mass
};

/// Applies an impulse along one row and books it as the joint's reaction; `lambda` is the caller's.
inline void push(JointConstraint& joint, int i, double lambda, Velocity& a, Velocity& b) {
    apply(joint.rows[i], lambda, a, b);
    joint.totalImpulse += lambda * joint.rows[i].j.linear;
    joint.totalTwist += lambda * joint.rows[i].j.angularB;
}

/// How many rows hold: 3 of a ball, 1 of a distance, 5 of a hinge, 6 of a weld ...
int rowCount(JointType type);
/// The same where it depends on more: none of a distance that is free, what a sixDof locks.
int rowCount(const JointDef& def);
/// Places in a tree: 3 of a rod, whose row has any direction, 6 of a slider; 0 of those that are swept.
int treeRowsOf(JointType type);

JointGeometry geometryOf(const Joint& joint, const Pose& a, const Pose& b);

/// C and J of any joint.
JointRows rowsOf(JointType type, const JointGeometry& geometry);

/// The coordinates that a joint leaves free, and how they change with the velocities: x and J.
JointRows coordinatesOf(const Joint& joint, const Pose& a, const Pose& b);

/// The same; keeps in mind where they are. To be called before any has gone on by half a turn.
JointRows followCoordinates(Joint& joint, const Pose& a, const Pose& b);

}  // namespace engine
