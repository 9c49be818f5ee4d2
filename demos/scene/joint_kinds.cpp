#include "demos/scene/joint_kinds.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace demos {
namespace {

using engine::JointType;

const JointKind kJointKinds[] = {
    {"ball",
     JointType::ball,
     {},
     {"anchor", "anchor_a", "anchor_b", "axis", "twist_deg", "swing_deg", "spring"}},
    {"distance",
     JointType::distance,
     {},
     {"anchor_a", "anchor_b", "length", "limits", "motor", "spring"}},
    {"hinge",
     JointType::hinge,
     {"axis"},
     {"anchor", "anchor_a", "anchor_b", "limits_deg", "motor", "spring", "soft", "inertia"}},
    {"weld", JointType::weld, {}, {"anchor", "anchor_a", "anchor_b", "spring"}},
    {"slider",
     JointType::slider,
     {"axis"},
     {"anchor", "anchor_a", "anchor_b", "limits", "motor", "spring", "soft", "inertia"}},
    {"universal",
     JointType::universal,
     {"axis", "axis2"},
     {"anchor", "anchor_a", "anchor_b", "limits_deg", "limits2_deg", "motor", "motor2", "spring"}},
    {"constant-velocity",
     JointType::constantVelocity,
     {"axis"},
     {"anchor", "anchor_a", "anchor_b", "axis2", "swing_deg", "spring"}},
    {"look-at", JointType::lookAt, {"axis"}, {"anchor_a", "anchor_b", "spring"}},
    {"axis", JointType::axis, {"axis"}, {"axis2", "limits_deg", "motor", "spring", "soft"}},
    {"six-dof",
     JointType::sixDof,
     {},
     {"anchor", "anchor_a", "anchor_b", "axis", "axis2", "x", "y", "z", "rx", "ry", "rz",
      "spring"}},
    {"gear", JointType::gear, {"axis", "ratio"}, {"axis2", "spring"}},
    {"wheel",
     JointType::wheel,
     {"axis", "axis2"},
     {"anchor", "anchor_a", "anchor_b", "limits", "motor", "spring", "soft"}},
    {"path",
     JointType::path,
     {"points"},
     {"anchor_b", "closed", "limits", "motor", "spring", "soft"}},
};

/// An example of each required key, for the message that it is missing.
constexpr std::pair<const char*, const char*> kNeededKeyExamples[] = {
    {"axis", "[0, 0, 1]"},
    {"axis2", "[1, 0, 0]"},
    {"ratio", "-2"},
    {"points", "[[0, 1, 0], [2, 2, 0], [4, 1, 0]]"},
};

const char* exampleOf(const std::string& key) {
    for (const auto& [name, example] : kNeededKeyExamples)
        if (key == name) return example;
    return "";
}

bool holds(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string kindsWith(const std::string& key) {
    std::vector<std::string> names;
    for (const JointKind& kind : kJointKinds)
        if (kind.has(key)) names.push_back(kind.name);
    return anyOf(names);
}

}  // namespace

bool JointKind::has(const std::string& key) const { return holds(needs, key) || holds(takes, key); }

std::string JointKind::text() const {
    return (std::string("aeiou").find(name[0]) != std::string::npos && name != "universal" ? "an "
                                                                                           : "a ") +
           name + " joint";
}

std::span<const JointKind> jointKinds() { return kJointKinds; }

std::vector<std::string> jointKindNames() {
    std::vector<std::string> names;
    for (const JointKind& kind : kJointKinds) names.push_back(kind.name);
    return names;
}

void checkJointKeys(Keys& keys, const JointKind& kind) {
    for (const std::string& key : kind.needs)
        if (!keys.has(key))
            keys.complain(
                "type", kind.text() + " has no " + key + "; write " + key + " = " + exampleOf(key));
    for (const JointKind& other : kJointKinds)
        for (const std::vector<std::string>* list : {&other.needs, &other.takes})
            for (const std::string& key : *list) {
                if (kind.has(key) || !keys.any(key)) continue;
                keys.complain(key, kind.text() + " has no " + key + "; leave it out, or make it " +
                                       kindsWith(key));
            }
}

}  // namespace demos
