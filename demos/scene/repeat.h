/// [[repeat]]: one body, joint or force in the file, many in the scene. Unrolling makes no copy of
/// the text: an instance is the written table, what i and j are, and how it is moved.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "demos/scene/keys.h"

namespace demos {

constexpr int kMostBodies = 10'000;
constexpr int kMostJoints = 20'000;
constexpr int kMostForces = 10'000;

/// One level of repetition: turned about `about` (without: about itself), then moved.
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
    int depth = 0;          // 0: not in a [[repeat]]; 1: i counts; 2: i and j
    int index[2] = {0, 0};  // i, j
    Motion motion[2];       // of i, of j; the inner one first
    Vec3 jitter{0, 0, 0};   // m, for this instance alone

    /// Its table, to be read.
    Keys keys(std::string where, Complaints& complaints) const {
        return {*table, std::move(where), complaints};
    }
    /// {i} {i+1} {i-1} {j} ... replaced; outside of a [[repeat]] the text itself.
    std::string named(std::string_view text) const;
    Vec3 point(const Vec3& p) const;
    Quat rotation(const Quat& q) const;
    Vec3 direction(const Vec3& v) const;
};

struct Instances {
    std::vector<Instance> bodies, joints, forces;
};

/// All [[body]], [[joint]], [[force]] and [[repeat]] tables of the scene in the order of the file,
/// up to the limits. `seed`: of the jitter.
Instances unroll(const std::vector<const Value*>& bodies, const std::vector<const Value*>& joints,
                 const std::vector<const Value*>& forces,
                 const std::vector<const Value*>& repeats, std::uint64_t seed,
                 Complaints& complaints);

/// Steele, Lea, Flood 2014: 64 bits in, 64 well-mixed bits out. (The standard library's
/// distributions differ from one library to the next.)
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    /// In [-1, 1), 53 bits.
    double signedUnit();

private:
    std::uint64_t state_;
};

}  // namespace demos
