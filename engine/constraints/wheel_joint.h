/// Wheel: b moves along an axis h of a (the suspension) and spins about an axle k.
///   C = t.d   for two t perpendicular to h       two rows, as in a slider
///   C = t'.k_b  for two t' perpendicular to k    two rows, as in a hinge; k_b is fixed in b
/// The translation along h is free (a spring makes it a coil-over), and so is the spin (a motor
/// drives it).
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
