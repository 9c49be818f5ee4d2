/// <joint>s of a link, as one joint between it and the link around it.
#pragma once
#include "demos/mjcf/affine_force.h"
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// hinge, slide and ball as hinge, slider and ball; two hinges across each other as a universal
/// joint; slides and then hinges along three axes as six degrees of freedom. What else a link may
/// have cannot be one joint, and that is reported. `places`: of the links in scene.bodies; `forces`: of
/// actuators and tendons, by joint.
void addJoints(const BodyTree& tree, const std::vector<int>& places, const Context& context,
               const ForcesByName& forces, SceneDescription& scene, Names& names);

}  // namespace demos::mjcf
