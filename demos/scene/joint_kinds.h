/// The types of joints by their names in scene files, and the keys that each of them takes.
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
    std::vector<std::string> needs, takes;  // besides name, a, b, break_at, break_torque

    bool has(const std::string& key) const;
    /// "a hinge joint"
    std::string text() const;
};

/// In the order of engine::JointType.
std::span<const JointKind> jointKinds();
std::vector<std::string> jointKindNames();

/// Reports keys that this kind does not take, with the kinds that take them, and required keys that
/// are missing.
void checkJointKeys(Keys& keys, const JointKind& kind);

}  // namespace demos
