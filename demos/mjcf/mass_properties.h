/// Mass, centre of mass and inertia of composed bodies.
#pragma once
#include <span>

#include "demos/mjcf/axes.h"

namespace demos::mjcf {

struct MassProperties {
    double mass = 0.0;            // kg
    Vec3 centre = Vec3::Zero();   // m
    Mat3 inertia = Mat3::Zero();  // kg m^2, about the centre
};

/// The properties of a piece at `pose`, in outer axes.
MassProperties placed(const MassProperties& piece, const Pose& pose);

/// The properties of all pieces together, given in the same axes:
///   m = sum m_i,   c = sum m_i c_i / m,   I = sum I_i + m_i (d.d 1 - d d^T),   d = c_i - c
MassProperties together(std::span<const MassProperties> pieces);

/// Whether a dynamic body can have them: mass and inertia are large enough.
bool isMovable(const MassProperties& whole);

}  // namespace demos::mjcf
