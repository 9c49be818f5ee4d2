#include "engine/constraints/joint_constraint.h"

#include "engine/constraints/axis_joint.h"
#include "engine/constraints/ball_joint.h"
#include "engine/constraints/catmull_rom.h"
#include "engine/constraints/constant_velocity_joint.h"
#include "engine/constraints/distance_joint.h"
#include "engine/constraints/gear_joint.h"
#include "engine/constraints/hinge_joint.h"
#include "engine/constraints/look_at_joint.h"
#include "engine/constraints/path_joint.h"
#include "engine/constraints/six_dof_joint.h"
#include "engine/constraints/slider_joint.h"
#include "engine/constraints/universal_joint.h"
#include "engine/constraints/weld_joint.h"
#include "engine/constraints/wheel_joint.h"

namespace engine {
namespace {

constexpr double kCounts = 0.5;  // of an angle's weight; below, turns would wind its spring up for ever

/// Two directions perpendicular to an axis given in a body's axes, and fixed in the body.
void acrossOf(const Vec3& axis, const Quat& body, Vec3 (&across)[2]) {
    tangents(axis, across[0], across[1]);
    for (Vec3& t : across) t = body * t;
}

void addPath(const Joint& joint, const Pose& a, JointGeometry& g) {
    const JointDef& def = joint.def;
    g.armToB = g.armA + g.between;
    const Vec3 local = a.rotation.conjugate() * g.armToB;
    const double t = nearestOnCurve(def.path, def.closed, local, joint.nearest);
    const CurvePoint point = curveAt(def.path, def.closed, t);
    g.alongPath = a.rotation * point.first.normalized();
    tangents(g.alongPath, g.acrossPath[0], g.acrossPath[1]);
    g.fromPath = g.armToB - a.rotation * point.at;
    const int piece = smaller(static_cast<int>(t), pieces(def.path, def.closed) - 1);
    g.wayOnPath = joint.lengths[piece] + curveLength(def.path, def.closed, piece, t);
}

/// Adds what only the types after weld, and coordinates, need.
void addMore(const Joint& joint, const Pose& a, const Pose& b, JointGeometry& g) {
    g.axisA = a.rotation * joint.axisA;
    g.axis2A = a.rotation * joint.axis2A;
    g.axis2B = b.rotation * joint.axis2B;
    acrossOf(joint.axis2A, a.rotation, g.across2A);
    acrossOf(joint.axisB, b.rotation, g.acrossB);
    g.near = joint.position;
    g.ratio = joint.def.ratio;
    for (int i = 0; i < 6; ++i)
        if (joint.def.free[i].locked) g.locked |= 1u << i;
    g.startAxisA = joint.startA * joint.axisA;
    g.startAxisB = joint.startB * joint.axis2B;
    g.sinceStartA = a.rotation * joint.startA.conjugate();
    g.sinceStartB = b.rotation * joint.startB.conjugate();
    if (joint.def.type == JointType::path) addPath(joint, a, g);
}

JointGeometry usualGeometry(const Joint& joint, const Pose& a, const Pose& b) {
    JointGeometry g;
    g.armA = a.rotation * joint.def.anchorA;
    g.armB = b.rotation * joint.def.anchorB;
    g.between = (b.position + g.armB) - (a.position + g.armA);
    g.axisB = b.rotation * joint.axisB;
    acrossOf(joint.axisA, a.rotation, g.acrossA);
    g.turnA = a.rotation;
    g.turnB = b.rotation;
    g.turnAtStart = joint.turnAtStart;
    g.length = joint.def.length;
    return g;
}

/// Only what angles between the axes of a and b need.
JointGeometry turnGeometry(const Joint& joint, const Pose& a, const Pose& b) {
    JointGeometry g;
    g.axisA = a.rotation * joint.axisA;
    g.axis2B = b.rotation * joint.axis2B;
    g.turnA = a.rotation;
    g.turnB = b.rotation;
    g.turnAtStart = joint.turnAtStart;
    g.near = joint.position;
    return g;
}

/// Only angles between the axes of a and b are free.
bool onlyTurns(JointType type) {
    return type == JointType::ball || type == JointType::hinge || type == JointType::axis ||
           type == JointType::constantVelocity;
}

}  // namespace

JointGeometry geometryOf(const Joint& joint, const Pose& a, const Pose& b) {
    JointGeometry g = usualGeometry(joint, a, b);
    if (joint.def.type > JointType::weld) addMore(joint, a, b, g);
    return g;
}

int rowCount(JointType type) {
    switch (type) {
        case JointType::ball: return 3;
        case JointType::distance: return 1;
        case JointType::hinge: return 5;
        case JointType::weld: return 6;
        case JointType::slider: return 5;
        case JointType::universal: return 4;
        case JointType::constantVelocity: return 4;
        case JointType::lookAt: return 2;
        case JointType::axis: return 2;
        case JointType::sixDof: return 6;
        case JointType::gear: return 1;
        case JointType::wheel: return 4;
        case JointType::path: return 2;
    }
    return 0;
}

int lockedOf(const JointDef& def, int first) {
    int count = 0;
    for (int i = first; i < first + 3; ++i) count += def.free[i].locked ? 1 : 0;
    return count;
}

int treeRowsOf(const JointDef& def) {
    if (def.type == JointType::distance) return 3;
    if (def.type == JointType::slider) return 6;
    if (def.type == JointType::gear) return 5;
    if (def.type == JointType::sixDof) {
        const int twists = lockedOf(def, 3);
        return twists == 0 ? 3 : twists < 3 ? 5 : 6;
    }
    const bool swept = def.type > JointType::constantVelocity;
    return swept ? 0 : rowCount(def.type);
}

int rowCount(const JointDef& def) {
    if (def.type == JointType::distance) return def.spring.isSoft() || !def.acts() ? 1 : 0;
    if (def.type != JointType::sixDof) return rowCount(def.type);
    return lockedOf(def, 0) + lockedOf(def, 3);
}

JointRows rowsOf(JointType type, const JointGeometry& geometry) {
    JointRows rows;
    switch (type) {
        case JointType::ball: addBallRows(geometry, rows); break;
        case JointType::distance: addDistanceRow(geometry, rows); break;
        case JointType::hinge: addHingeRows(geometry, rows); break;
        case JointType::weld: addWeldRows(geometry, rows); break;
        case JointType::slider: addSliderRows(geometry, rows); break;
        case JointType::universal: addUniversalRows(geometry, rows); break;
        case JointType::constantVelocity: addConstantVelocityRows(geometry, rows); break;
        case JointType::lookAt: addLookAtRows(geometry, rows); break;
        case JointType::axis: addAxisRows(geometry, rows); break;
        case JointType::sixDof: addSixDofRows(geometry, rows); break;
        case JointType::gear: addGearRow(geometry, rows); break;
        case JointType::wheel: addWheelRows(geometry, rows); break;
        case JointType::path: addPathRows(geometry, rows); break;
    }
    return rows;
}

JointRows coordinatesOf(const Joint& joint, const Pose& a, const Pose& b) {
    JointRows free;
    const bool turns = onlyTurns(joint.def.type);
    JointGeometry g = turns ? turnGeometry(joint, a, b) : usualGeometry(joint, a, b);
    if (!turns) addMore(joint, a, b, g);
    switch (joint.def.type) {
        case JointType::ball: addBallCoordinates(g, free); break;
        case JointType::distance: addDistanceCoordinate(g, free); break;
        case JointType::hinge:
        case JointType::axis: addHingeCoordinate(g, free); break;
        case JointType::slider: addSliderCoordinate(g, free); break;
        case JointType::universal: addUniversalCoordinates(g, free); break;
        case JointType::constantVelocity: addConstantVelocityCoordinates(g, free); break;
        case JointType::sixDof: addSixDofCoordinates(g, free); break;
        case JointType::gear: addGearCoordinates(g, free); break;
        case JointType::wheel: addWheelCoordinates(g, free); break;
        case JointType::path: addPathCoordinate(g, free); break;
        case JointType::weld:
        case JointType::lookAt: break;
    }
    return free;
}

JointRows followCoordinates(Joint& joint, const Pose& a, const Pose& b) {
    if (joint.def.type == JointType::path)
        joint.nearest = nearestOnCurve(joint.def.path, joint.def.closed,
                                       a.toLocal(b.toWorld(joint.def.anchorB)), joint.nearest);
    JointRows free = coordinatesOf(joint, a, b);
    for (int i = 0; i < free.count; ++i) {
        const Freedom& f = joint.def.free[i];
        if (f.spring.isSoft() && free.weight[i] < kCounts) free.error[i] = unwrapped(free.error[i], f.rest);
        joint.position[i] = free.error[i];
    }
    return free;
}

}  // namespace engine
