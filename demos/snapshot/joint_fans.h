/// Lines of --show joints: the current values of a joint's coordinates and, in amber, their limits.
#pragma once
#include "demos/snapshot/frame_parts.h"

namespace demos {

constexpr float kAxisPixels = 2.0f, kArcPixels = 2.5f;  // widths, see render::Line

inline void addLine(const Vec3& from, const Vec3& to, float pixels, const render::Color& color,
                    render::Frame& frame) {
    frame.lines.push_back({drawn(from), drawn(to), pixels, color});
}

/// The angle of a hinge or an axis joint: a hand that shows the angle of b, and the limits.
/// `size` here and below: m, the extent of this joint's marks.
void addHingeAngle(const Stage& stage, const engine::JointState& joint, double size,
                   render::Frame& frame);

/// Limits of a ball or a constant velocity joint: the cone of the swing, the fan of the twist.
void addSwingAndTwist(const Stage& stage, const engine::JointState& joint, double size,
                      render::Frame& frame);

/// Limits of a universal joint's two angles.
void addUniversalAngles(const engine::JointState& joint, double size, render::Frame& frame);

/// The frame of a six-dof joint, fixed in a, at a's anchor; at b's anchor the limits of its
/// translations and rotations.
void addSixDof(const engine::JointState& joint, double size, render::Frame& frame);

/// A wheel's suspension: its travel, and, if it is sprung, a coil from the upper end to the wheel.
void addSuspension(const engine::JointState& joint, double size, render::Frame& frame);

}  // namespace demos
