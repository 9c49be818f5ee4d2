/// What a run did, step by step. Two runs are compared by it, and a baseline keeps it.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/body.h"

namespace demos {

/// What a contact or a joint did to its bodies since the moment before: mostly in one step.
struct TrajectoryImpulse {
    int constraint = 0;   // index in Trajectory::constraints
    double value = 0.0;   // N s: of a contact along its normals, all points; of a joint |force| dt, or
                          // N m s: |torque| dt about its anchor
};

/// What the names of constraints begin with.
inline constexpr std::string_view kContactPrefix = "contact ", kJointPrefix = "joint ",
                                  kTorquePrefix = "torque of joint ";

/// The scene after a step.
struct TrajectoryMoment {
    int step = 0;
    std::vector<engine::Pose>
        poses;  // by index in Trajectory::bodies; unit rotations of either sign
    double energy = 0.0;                 // J, all of it
    double penetration = 0.0;            // m, the deepest
    double separation = 0.0;             // m, of the joint that is farthest apart
    std::vector<TrajectoryImpulse> impulses;  // sorted by constraint; without zeros
};

/// The multiples to which numbers were rounded when they were kept; 0: not rounded.
struct TrajectoryResolution {
    double position = 0.0;  // m
    double rotation = 0.0;  // of a quaternion's four numbers
    double impulse = 0.0;   // N s and N m s
    double energy = 0.0;    // J
};

struct Trajectory {
    int hz = 60;                           // steps a second
    int dense = kAll;                      // all steps up to this one have a moment; up to twice
                                           // it every 2nd has, up to four times it every 4th, ...
    std::vector<std::string> bodies;       // names, by index in the scene
    std::vector<engine::Vec3> extents;     // m, half sides of each body's box, in its axes; 0: none
    std::vector<double> masses;            // kg, 0 unless dynamic; none at all: not known
    double gravity = 0.0;                  // m/s^2, its magnitude
    std::vector<std::string> constraints;  // "contact box8-box9", "torque of joint hook", by first occurrence
    std::vector<std::array<int, 2>> ends;  // of each constraint: indices of its bodies; -1: the world
    std::vector<std::uint32_t> hashes;     // of the state, half of its bits, by step from 0
    std::vector<TrajectoryMoment> moments;  // by step, with step 0 and the last step
    TrajectoryResolution resolution;
    static constexpr int kAll = 1 << 30;

    double timeOf(int step) const { return static_cast<double>(step) / hz; }  // s
    int lastStep() const { return static_cast<int>(hashes.size()) - 1; }
};

/// Whether a step has a moment in a trajectory with this `dense`; the last step always has one. The
/// start of a difference is wanted to the exact step early in a run; later, with a precision in
/// proportion to the elapsed time.
bool hasMoment(int step, int dense);

}  // namespace demos
