/// Wheel: b rides along an axis h of a (the way of the suspension) and spins about an axle k.
///   C = t.d   for the two t across h             two rows, as in a slider
///   C = t'.k_b  for the two t' across k          two rows, as in a hinge; k_b is fixed in b
/// Free are the way along h, which a spring makes a coil-over, and the spin, which a motor drives.
#pragma once
#include "engine/constraints/hinge_joint.h"
#include "engine/constraints/slider_joint.h"

namespace engine {

inline void addWheelRows(const JointGeometry& g, JointRows& rows) {
    addAcrossRows(g, rows);
    addParallelRows(g.across2A, g.axis2B, rows);
}

inline void addWheelCoordinates(const JointGeometry& g, JointRows& coordinates) {
    addSliderCoordinate(g, coordinates);
    addTurn(twistAbout(g.axis2A, turnSinceStart(g), g.near[1]), coordinates);
}

}  // namespace engine
