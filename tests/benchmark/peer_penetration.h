/// How deep bodies penetrate each other, computed from their shapes and poses alone, since engines
/// define penetration differently.
#pragma once
#include <set>
#include <span>
#include <utility>

#include "tests/benchmark/peer_engine.h"

namespace peers {

/// Over all pairs that overlap.
struct Penetration {
    double worst = 0.0;  // m
    double mean = 0.0;   // m
};

class PenetrationCheck {
public:
    explicit PenetrationCheck(const Scene& scene);
    Penetration measure(std::span<const BodyState> states) const;

private:
    using Pair = std::pair<int, int>;  // bodies

    std::vector<Pair> pairsOfLarge() const;
    std::vector<Pair> pairsOfNeighbours(std::span<const BodyState> states) const;
    bool mayMeet(const Pair& pair) const;

    const Scene& scene_;
    std::set<Pair> joined_;           // lower number first
    std::vector<int> small_, large_;  // bodies that collide; large: larger than a cell
};

/// m; zero or negative: apart. For boxes and spheres.
double penetration(const Body& a, const Pose& poseA, const Body& b, const Pose& poseB);

}  // namespace peers
