/// Lines of --show joints: a joint's coordinates, where they stand and, in amber, their limits.
#pragma once
#include "demos/snapshot/frame_parts.h"

namespace demos {

constexpr float kAxisPixels = 2.0f, kArcPixels = 2.5f;  // widths, see render::Line

inline void addLine(const Vec3& from, const Vec3& to, float pixels, const render::Color& color,
                    render::Frame& frame) {
    frame.lines.push_back({drawn(from), drawn(to), pixels, color});
}

/// The angle of a hinge or an axis joint: its hand, which shows where b stands, and its limits.
/// `size` here and below: m, how far the marks of this joint reach.
void addHingeAngle(const Stage& stage, const engine::JointState& joint, double size,
                   render::Frame& frame);

/// Limits of a ball or a constant velocity joint: the cone of the swing, the fan of the twist.
void addSwingAndTwist(const Stage& stage, const engine::JointState& joint, double size,
                      render::Frame& frame);

/// Limits of a universal joint's two angles.
void addUniversalAngles(const engine::JointState& joint, double size, render::Frame& frame);

/// A six-dof's frame, as a carries it, at a's anchor; at b's the limits of its ways and turns.
void addSixDof(const engine::JointState& joint, double size, render::Frame& frame);

/// A wheel's suspension: its way, and where it is sprung a coil from the upper end to the wheel.
void addSuspension(const engine::JointState& joint, double size, render::Frame& frame);

}  // namespace demos
