/// What a run did, step by step: what two runs are compared by, and what a baseline keeps.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/body.h"

namespace demos {

/// What a contact or a joint did to its bodies in one step.
struct CourseImpulse {
    int constraint = 0;   // place in Course::constraints
    double value = 0.0;   // N s: a contact's along its normals, all points; a joint's |force| times dt
};

/// After a step.
struct CourseMoment {
    int step = 0;
    std::vector<engine::Pose> poses;     // by place in Course::bodies; unit rotations with w >= 0
    double energy = 0.0;                 // J, all of it
    double penetration = 0.0;            // m, the deepest
    double separation = 0.0;             // m, of the joint that is farthest apart
    std::vector<CourseImpulse> impulses; // by constraint, rising; of those that did anything
};

struct Course {
    int hz = 60;                           // steps a second
    int every = 1;                         // steps from one moment to the next
    std::vector<std::string> bodies;       // names, by place in the scene
    std::vector<engine::Vec3> extents;     // m, half sides of a box about each, in its axes; 0: none
    std::vector<std::string> constraints;  // "box8-box9" or a joint's name, in order of appearance
    std::vector<std::uint32_t> hashes;     // of the state, half of its bits, by step from 0
    std::vector<CourseMoment> moments;     // by step; 0 first, the last step last

    double timeOf(int step) const { return static_cast<double>(step) / hz; }  // s
};

}  // namespace demos
