/// From links to the bodies of a scene.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/body_tree.h"

namespace demos::mjcf {

/// What no joint lets move is a fixed body for each <geom>; a link is one body, its <geom>s a
/// compound. Gives the links' places in scene.bodies.
std::vector<int> addBodies(const BodyTree& tree, const Context& context, SceneDescription& scene);

/// Names for a scene's bodies or joints, each one once.
class Names {
public:
    /// Letters that a name may not have become '_', and a number is added where it is taken.
    std::string next(const std::string& wanted);

private:
    std::map<std::string, int> counts_{{"world", 1}};  // the last number of each
};

}  // namespace demos::mjcf
