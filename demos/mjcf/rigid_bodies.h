/// From links to the bodies of a scene.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/body_tree.h"

namespace demos::mjcf {

/// Each <geom> that cannot move becomes a fixed body; a link becomes one body, its <geom>s a
/// compound. Gives the indices of the links in scene.bodies.
std::vector<int> addBodies(const BodyTree& tree, const Context& context, SceneDescription& scene);

/// Unique names for a scene's bodies or joints.
class Names {
public:
    /// Replaces characters that a name may not have by '_', and adds a number to a name in use.
    std::string next(const std::string& wanted);

private:
    std::map<std::string, int> counts_{{"world", 1}};  // the last number of each
};

}  // namespace demos::mjcf
