/// [[repeat]]: one body, joint or force in the file, many in the scene. Unrolling does not copy the
/// table: an instance refers to it and adds the indices i, j, k and the motion.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/keys.h"
#include "demos/scene/split_mix.h"

namespace demos {

constexpr int kMostBodies = 10'000;
constexpr int kMostJoints = 20'000;
constexpr int kMostForces = 10'000;
constexpr std::size_t kMostAttracting = 2000;  // bodies of an n-body-gravity; all of them have no more pairs
/// Values in the tables of all of these: a [[repeat]] multiplies large shapes and paths.
constexpr std::size_t kMostUnrolledValues = 2'000'000;

/// One level of repetition: a rotation about `about` (default: about itself), then a translation.
struct Motion {
    Quat turn = Quat::Identity();
    std::optional<Vec3> about;
    Vec3 shift{0, 0, 0};  // m

    Vec3 point(const Vec3& p) const {
        return (about ? Vec3(*about + turn * (p - *about)) : p) + shift;
    }
};

struct Instance {
    const Value* table = nullptr;
    Scope scope;                    // with the indices of the [[repeat]]s around it
    Motion motion[kDeepestRepeat];  // of i, j, k; the innermost first
    Vec3 jitter{0, 0, 0};           // m, for this instance alone

    /// Access to its table. The instance has to outlive the result.
    Keys keys(std::string where, Complaints& complaints) const {
        return {*table, std::move(where), complaints, scope};
    }
    bool isRepeated() const { return scope.turns.depth > 0; }
    /// In a [[repeat]], replaces every expression in braces by its whole number: {i} {i+1}
    /// {2*i+j}. One without a whole result stays, and `wrong` says why.
    std::string named(std::string_view text, std::string& wrong) const;
    /// The same for the text of `key`; errors are reported there.
    std::string named(std::string_view text, Keys& keys, std::string_view key) const;
    Vec3 point(const Vec3& p) const;
    Quat rotation(const Quat& q) const;
    Vec3 direction(const Vec3& v) const;
};

struct Instances {
    std::vector<Instance> bodies, joints, forces;
    bool incomplete = false;  // after an error: a limit was reached
};

/// The tables of a scene that may be in a [[repeat]], and the [[repeat]]s.
struct Repeatable {
    std::vector<const Value*> bodies, joints, forces, repeats;
};

/// All of them in the order of the file, up to the limits. `seed`: of the jitter.
Instances unroll(const Repeatable& tables, std::uint64_t seed, const Scope& scope,
                 Complaints& complaints);

}  // namespace demos
