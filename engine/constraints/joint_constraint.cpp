#include "engine/constraints/joint_constraint.h"

#include "engine/constraints/ball_joint.h"
#include "engine/constraints/distance_joint.h"
#include "engine/constraints/hinge_joint.h"
#include "engine/constraints/weld_joint.h"

namespace engine {

JointGeometry<double> geometryOf(const Joint& joint, const Pose& a, const Pose& b) {
    JointGeometry<double> g;
    g.armA = a.rotation * joint.def.anchorA;
    g.armB = b.rotation * joint.def.anchorB;
    g.between = (b.position + g.armB) - (a.position + g.armA);
    g.axisB = b.rotation * joint.axisB;
    tangents(joint.axisA, g.acrossA[0], g.acrossA[1]);
    for (Vec3& across : g.acrossA) across = a.rotation * across;
    g.turnA = a.rotation;
    g.turnB = b.rotation;
    g.turnAtStart = joint.turnAtStart;
    g.length = joint.def.length;
    return g;
}

int rowCount(JointType type) {
    switch (type) {
        case JointType::ball: return 3;
        case JointType::distance: return 1;
        case JointType::hinge: return 5;
        case JointType::weld: return 6;
        default: return 0;
    }
}

template <class Real>
JointRows<Real> rowsOf(JointType type, const JointGeometry<Real>& geometry) {
    JointRows<Real> rows;
    switch (type) {
        case JointType::ball: addBallRows(geometry, rows); break;
        case JointType::distance: addDistanceRow(geometry, rows); break;
        case JointType::hinge: addHingeRows(geometry, rows); break;
        case JointType::weld: addWeldRows(geometry, rows); break;
        default: break;
    }
    return rows;
}

template JointRows<float> rowsOf(JointType, const JointGeometry<float>&);
template JointRows<double> rowsOf(JointType, const JointGeometry<double>&);

}  // namespace engine
