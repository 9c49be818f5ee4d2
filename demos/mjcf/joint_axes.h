/// One <joint>: its way or turn, and what acts along it.
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
    Vec3 axis{0, 1, 0};       // likewise, of length 1
    engine::Freedom freedom;  // along the axis; the bodies' places in the file count as 0
    Spot spot;
};

/// `pose`: of the <body> that has it; `forces`: of actuators and tendons, by its name.
JointAxis readJoint(const JointElement& joint, const Pose& pose, const Context& context,
                    const ForcesByName& forces);

}  // namespace demos::mjcf
