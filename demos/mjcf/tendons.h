/// <tendon>: translated to forces along joints, springs and distance joints.
#pragma once
#include "demos/mjcf/actuators.h"
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// <fixed>: adds the forces along its joints to those of the actuators. A spring, a damper or an
/// actuator whose force depends on the tendon is supported for one joint only.
void addFixedTendons(const Element& root, const BodyTree& tree, const Context& context,
                     Actuation& actuation);

/// <spatial> between two <site>s: a distance joint with limits, spring and force, or a spring
/// alone, whose bodies can collide. `places`: indices of the links in scene.bodies.
void addSpatialTendons(const Element& root, const BodyTree& tree, const std::vector<int>& places,
                       const Context& context, const Actuation& actuation,
                       SceneDescription& scene, Names& names);

}  // namespace demos::mjcf
