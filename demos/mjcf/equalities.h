/// <equality>: <connect> as a ball joint, <weld> as a weld.
#pragma once
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// `places`: indices of the links in scene.bodies.
void addEqualities(const Element& root, const BodyTree& tree, const std::vector<int>& places,
                   const Context& context, SceneDescription& scene, Names& names);

}  // namespace demos::mjcf
