/// Mass, centre of mass and inertia of what is put together.
#pragma once
#include <span>

#include "demos/mjcf/axes.h"

namespace demos::mjcf {

struct MassProperties {
    double mass = 0.0;            // kg
    Vec3 centre = Vec3::Zero();   // m
    Mat3 inertia = Mat3::Zero();  // kg m^2, about the centre
};

/// The same seen from outside: of a piece at `pose`.
MassProperties placed(const MassProperties& piece, const Pose& pose);

/// Of all pieces, which are in the same axes:
///   m = sum m_i,   c = sum m_i c_i / m,   I = sum I_i + m_i (d.d 1 - d d^T),   d = c_i - c
MassProperties together(std::span<const MassProperties> pieces);

/// Whether something with it can be moved: mass and inertia well above nothing.
bool isMovable(const MassProperties& whole);

}  // namespace demos::mjcf
