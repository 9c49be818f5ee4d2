/// The rows of joints. Every joint type has its own file with C and J on top; this file has what they share.
/// All rows are equalities: lambda is unbounded. drive.h handles the free coordinates.
#pragma once
#include <array>

#include "engine/constraints/soft.h"
#include "engine/constraints/turning.h"

namespace engine {

/// A joint of a world, kept from step to step.
struct Joint {
    JointDef def;
    Vec3 axisA = Vec3::UnitZ(), axisB = Vec3::UnitZ();    // `axis` in the axes of a and b
    Quat turnAtStart = Quat::Identity();                  // q_a^-1 q_b of the straight joint
    Vec3 axis2A = Vec3::UnitX(), axis2B = Vec3::UnitX();  // axis2 in the axes of a and b
    Quat startA = Quat::Identity(), startB = Quat::Identity();  // gear: initial rotations
    std::vector<double> lengths;                          // path: m, from its start to each point
    std::array<double, 6> rowMasses{}, freeMasses{};      // K of rows and coordinates where it was made
    double nearest = 0.0;                                 // path: parameter of the nearest point
    bool present = true, broken = false;
    bool torn = false;                                    // by constraints that cannot all hold,
    double calm = 0.0;                                    // s, since all connected joints have closed
    bool inLoop = false;                                  // its tree has loops, and no joint outside acts on it
    bool solvedAtOnce = false;                            // with its tree, and no joint outside acts on it
    bool acts = false;                                    // a spring, motor, limit or rotor acts
    std::array<double, 6> position{};                     // of the coordinates, to count turns
    std::array<double, 6> lambda{};                       // N s (N m s), in one sub-step
    std::array<double, 18> driven{};                      // the same, along coordinates (drive.h)
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();   // N, N m on b: see JointState
};

/// The inputs of a joint's C and J, in world axes.
struct JointGeometry {
    Vec3 armA, armB;    // m, from the centres of mass to the anchors
    Vec3 between;       // m, p_b - p_a
    Vec3 axisB;         // hinge: its axis, fixed in b
    Vec3 acrossA[2];    // hinge: two unit vectors perpendicular to its axis, fixed in a
    Quat turnA, turnB;  // rotations of the two bodies
    Quat turnAtStart;   // weld
    double length;      // m, distance

    // The rest is only for the types after weld, and for coordinates.
    Vec3 axisA, axis2A, axis2B;                  // fixed in a, a, b
    Vec3 across2A[2], acrossB[2];                // perpendicular to axis2A, axisB
    std::array<double, 6> near{};                // recent values of the coordinates
    unsigned locked = 0;                         // sixDof: one bit per coordinate
    double ratio = 1.0;                          // gear
    Vec3 startAxisA, startAxisB;                 // gear: axisA and axis2B initially,
    Quat sinceStartA, sinceStartB;               // and q q_0^-1
    Vec3 armToB, fromPath;                       // path: p_b - x_a, p_b - p(s)
    Vec3 alongPath, acrossPath[2];
    double wayOnPath = 0.0;  // m
};

/// The rotation of b relative to a since the start, in world axes.
inline Quat turnSinceStart(const JointGeometry& g) {
    return g.turnB * (g.turnA * g.turnAtStart).conjugate();
}

struct JointRows {
    static constexpr int kMaxRows = 6;
    int count = 0;
    std::array<Jacobian, kMaxRows> j;
    std::array<double, kMaxRows> error;  // C, m or rad
    std::array<double, kMaxRows> weight;
    std::array<Vec3, kMaxRows> weightRate;  // of angles, where the weight is below 1

    void add(const Jacobian& jacobian, double c) {
        j[count] = jacobian;
        weight[count] = 1.0;
        error[count++] = c;
    }
    /// For a spring along row i: C becomes m (C - rest), with its J. A spring on an angle alone would pull ever harder
    /// towards where the angle is undefined, and jump there: it would gain energy.
    void fade(int i, double rest = 0.0) {
        error[i] -= rest;
        if (weight[i] == 1.0) return;
        j[i].angularA = weight[i] * j[i].angularA - error[i] * weightRate[i];
        j[i].angularB = weight[i] * j[i].angularB + error[i] * weightRate[i];
        error[i] *= weight[i];
    }
};

/// Adds the row of an angle; `sign` is the sign of its rate.
inline void addTurn(const Angle& angle, JointRows& rows, double sign = 1.0) {
    rows.add({Vec3::Zero(), Vec3(-sign * angle.rate), Vec3(sign * angle.rate)}, angle.value);
    rows.weight[rows.count - 1] = angle.weight;
    rows.weightRate[rows.count - 1] = sign * angle.weightRate;
}

struct JointConstraint {
    int a = -1, b = -1;
    int count = 0;
    int joint = -1;      // number in the world
    int stride = 1;      // of its bodies (solver/paces.h); 0: they wait in this sub-step
    bool inTree = false; // solved with its tree, not in the sweep
    bool torn = false;   // see Joint
    double kept = 1.0;   // share of the previous impulses used as the start in this sub-step
    std::array<Row, 6> rows;
    std::array<double, 6> error{}, bias{}, softness{}, lambda{};
    std::array<double, 6> bend{};  // kappa (solver/chords.h), m/s or rad/s
    Spring spring;
    std::array<Spring, 6> springs;  // of a soft joint's rows, by k and c
    std::array<double, 6> before{};  // u of a soft joint's rows: rates before the sub-step's forces
    bool pointAtOnce = false;  // the first three rows, of a point, are solved together
    Mat3 pointMass = Mat3::Zero();  // (J M^-1 J^T)^-1 of these three
    bool asBlock = false;      // a type after weld: all its rows are one block if points are blocks
    bool isGear = false;
    int treeRows = 0;          // rows that it takes in a tree (tree_joint.h); 0: not part of a tree
    bool allAtOnce = false;    // all rows are solved together
    Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();  // the same for all rows
    Vec3 totalImpulse = Vec3::Zero();  // N s on b, over the whole step
    Vec3 totalTwist = Vec3::Zero();    // N m s on b about its centre of mass
};

/// Applies an impulse along one row and adds it to the joint's reaction; the caller updates lambda.
inline void push(JointConstraint& joint, int i, double lambda, Velocity& a, Velocity& b) {
    apply(joint.rows[i], lambda, a, b);
    joint.totalImpulse += lambda * joint.rows[i].j.linear;
    joint.totalTwist += lambda * joint.rows[i].j.angularB;
}

/// The number of rows: ball 3, distance 1, hinge 5, weld 6 ...
int rowCount(JointType type);
/// The same for a definition: 0 for a free distance, the locked coordinates for a sixDof.
int rowCount(const JointDef& def);
/// Rows in a tree, the first three for a point, the others for twists: 3 for a rod, whose row has any
/// direction, 5 for a gear, whose row is the fourth, 6 for a slider, 0 for types that are swept.
int treeRowsOf(const JointDef& def);
/// The number of locked coordinates of a sixDof, from `first` on, of three.
int lockedOf(const JointDef& def, int first);

JointGeometry geometryOf(const Joint& joint, const Pose& a, const Pose& b);

/// C and J of a joint of any type.
JointRows rowsOf(JointType type, const JointGeometry& geometry);

/// The free coordinates of a joint, and their Jacobians: x and J.
JointRows coordinatesOf(const Joint& joint, const Pose& a, const Pose& b);

/// The same; also stores their values. Must be called before any coordinate has moved by half a turn.
JointRows followCoordinates(Joint& joint, const Pose& a, const Pose& b);

}  // namespace engine
