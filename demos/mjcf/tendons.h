/// <tendon>: what joints, springs and limits of a distance say as well.
#pragma once
#include "demos/mjcf/actuators.h"
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// <fixed>: the forces along its joints, put to those of the actuators. A spring, a damper or an actuator
/// that follows it: of one joint only.
void addFixedTendons(const Element& root, const BodyTree& tree, const Context& context,
                     Actuation& actuation);

/// <spatial> between two <site>s: a distance joint with limits, spring and force, or a spring alone,
/// which lets its bodies collide. `places`: of the links in scene.bodies.
void addSpatialTendons(const Element& root, const BodyTree& tree, const std::vector<int>& places,
                       const Context& context, const Actuation& actuation,
                       SceneDescription& scene, Names& names);

}  // namespace demos::mjcf
