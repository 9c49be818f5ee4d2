/// What a run did, step by step: what two runs are compared by, and what a baseline keeps.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/body.h"

namespace demos {

/// What a contact or a joint did to its bodies in one step.
struct TrajectoryImpulse {
    int constraint = 0;   // place in Trajectory::constraints
    double value = 0.0;   // N s: a contact's along its normals, all points; a joint's |force| times dt
};

/// After a step.
struct TrajectoryMoment {
    int step = 0;
    std::vector<engine::Pose>
        poses;  // by place in Trajectory::bodies; unit rotations of either sign
    double energy = 0.0;                 // J, all of it
    double penetration = 0.0;            // m, the deepest
    double separation = 0.0;             // m, of the joint that is farthest apart
    std::vector<TrajectoryImpulse> impulses;  // by constraint, rising; of those that did anything
};

/// To what numbers were rounded when they were kept; 0: not at all.
struct TrajectoryResolution {
    double position = 0.0;  // m
    double rotation = 0.0;  // of a quaternion's four numbers
    double impulse = 0.0;   // N s
    double energy = 0.0;    // J
};

struct Trajectory {
    int hz = 60;                           // steps a second
    int dense = kAll;                      // steps up to this one all have a moment; up to twice
                                           // it every 2nd has, up to four times it every 4th, ...
    std::vector<std::string> bodies;       // names, by place in the scene
    std::vector<engine::Vec3> extents;     // m, half sides of a box about each, in its axes; 0: none
    std::vector<std::string> constraints;  // "contact box8-box9", "joint hook", as they come up
    std::vector<std::uint32_t> hashes;     // of the state, half of its bits, by step from 0
    std::vector<TrajectoryMoment> moments;  // by step: 0 first, the last step last
    TrajectoryResolution resolution;
    static constexpr int kAll = 1 << 30;

    double timeOf(int step) const { return static_cast<double>(step) / hz; }  // s
    int lastStep() const { return static_cast<int>(hashes.size()) - 1; }
};

/// Whether a step has a moment in a trajectory that is so dense; the last step has one besides.
/// What goes wrong is wanted to the step where it begins, and later on only as well as the time so
/// far.
bool hasMoment(int step, int dense);

}  // namespace demos
