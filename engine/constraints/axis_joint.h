/// Axis: an axis of b stays parallel to one of a, whatever the positions.
///   C = t.h_b, two rows, as in a hinge
/// It is a hinge without its point. The opposite direction is parallel too: if the axes are at more
/// than a right angle when the joint is made, it settles there. The angle about the axis is free.
#pragma once
#include "engine/constraints/hinge_joint.h"

namespace engine {

inline void addAxisRows(const JointGeometry& g, JointRows& rows) {
    addParallelRows(g.acrossA, g.axis2B, rows);
}

}  // namespace engine
