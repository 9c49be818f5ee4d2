/// The <joint>s of a link, as one joint between it and its parent.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// hinge, slide and ball become hinge, slider and ball; two hinges at right angles a universal
/// joint; slides and then hinges along three axes a six-dof joint. Other combinations cannot be one
/// joint and are reported. `places`: indices of the links in scene.bodies; `forces`: of actuators
/// and tendons, by joint.
void addJoints(const BodyTree& tree, const std::vector<int>& places, const Context& context,
               const ForcesByName& forces, SceneDescription& scene, Names& names);

}  // namespace demos::mjcf
