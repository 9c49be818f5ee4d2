/// Which bodies collide: contype and conaffinity of the geoms, and <exclude>.
#pragma once
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// Two bodies collide if contype of one shares a bit with conaffinity of the other. This takes a
/// group for each pair of contype and conaffinity that some body ignores, and one for each body1 of
/// an <exclude>, at most 32 in all. `places`: indices of the links in scene.bodies.
void separate(const Element& root, const BodyTree& tree, const std::vector<int>& places,
              const Context& context, SceneDescription& scene);

}  // namespace demos::mjcf
