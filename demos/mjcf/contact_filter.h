/// Who meets whom: contype and conaffinity of the geoms, and <exclude>.
#pragma once
#include "demos/mjcf/rigid_bodies.h"

namespace demos::mjcf {

/// Two bodies meet if contype of one has a bit of conaffinity of the other: a group for each pair
/// of the two that is ignored by some, and one for each <exclude>, 32 in all. `places`: of the
/// links in scene.bodies.
void separate(const Element& root, const BodyTree& tree, const std::vector<int>& places,
              const Context& context, SceneDescription& scene);

}  // namespace demos::mjcf
