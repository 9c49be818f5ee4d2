/// Axis: an axis of b stays parallel to one of a; where the two are does not matter.
///   C = t.h_b, two rows, as in a hinge
/// It is the hinge without its point. The opposite direction is parallel as well: made with the two
/// axes at more than a right angle, it settles there. Free is the angle about the axis.
#pragma once
#include "engine/constraints/hinge_joint.h"

namespace engine {

inline void addAxisRows(const JointGeometry& g, JointRows& rows) {
    addParallelRows(g.acrossA, g.axis2B, rows);
}

}  // namespace engine
