/// The types of joints as a scene file calls them, and which keys each of them takes.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "demos/scene/keys.h"
#include "engine/joint.h"

namespace demos {

struct JointKind {
    std::string name;
    engine::JointType type;
    std::vector<std::string> needs, takes;  // keys; name, a, b, break_at, break_torque: all of them

    bool has(const std::string& key) const;
    /// "a hinge joint"
    std::string text() const;
};

/// In the order of engine::JointType.
std::span<const JointKind> jointKinds();
std::vector<std::string> jointKindNames();

/// Complains of keys that this kind lacks, with the kinds that have them, and of those that are
/// not given and should be.
void checkJointKeys(Keys& keys, const JointKind& kind);

}  // namespace demos
