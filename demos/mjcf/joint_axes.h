/// One <joint>: its translation or rotation, and what acts along it.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/body_tree.h"
#include "engine/joint.h"

namespace demos::mjcf {

enum class JointWord { hinge, slide, ball };

struct JointAxis {
    std::string name;
    JointWord word = JointWord::hinge;
    Vec3 anchor{0, 0, 0};     // m, world axes, y up
    Vec3 axis{0, 1, 0};       // unit, world axes, y up
    engine::Freedom freedom;  // along the axis; 0 at the poses of the file
    Spot spot;
};

/// `pose`: that of the <body> with the joint; `forces`: of actuators and tendons, by joint.
JointAxis readJoint(const JointElement& joint, const Pose& pose, const Context& context,
                    const ForcesByName& forces);

}  // namespace demos::mjcf
