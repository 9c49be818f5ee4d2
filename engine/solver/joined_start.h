/// fresh_start.h for islands with joints. What limits, motors, contacts and joints outside the trees keep from
/// the last sub-step is a guess, and where the trees let bodies hardly follow it (0.01 kg limits 100 kg behind
/// another joint) sweeps do not take a bad one back: each sub-step adds energy.
/// The energy that all impulses of an island have brought, those of the trees included,
///   f = sum of lambda . (J (v0 + v) / 2 + b + gamma lambda / 2),   v0, v: before and after the sub-step's impulses
/// is at most 0 after any number of sweeps from lambda = 0: the trees are solved exactly, and every other row
/// reduces f. So f > 0 comes from what was kept, which is taken back then; the island is swept again from 0. A motor
/// and a moving surface may give energy: their speeds are in b and in J v.
///
/// f is measured only where the last sweep still changed a velocity by more than 0.25 m/s or rad/s: a structure that
/// rests or trembles keeps its impulses.
#pragma once
#include <span>
#include <vector>

#include "engine/dynamics/bodies.h"

namespace engine {

struct Solver;

class JoinedStart {
public:
    /// Before the first impulse of a sub-step, after the bounces: stores the velocities.
    void begin(const Solver& s, std::span<const Velocity> v);
    /// Takes back the impulses of the islands of a group that have brought energy; returns whether there was one.
    bool takeBack(Solver& s, int group, Bodies& bodies);

private:
    void findIslands(Solver& s, int group, const Bodies& bodies);
    void measure(Solver& s, int group, const Bodies& bodies);
    Velocity midway(int body, std::span<const Velocity> v) const;

    std::vector<Velocity> start_;  // v0, by body
    std::vector<double> brought_;  // f in J, by island
    std::vector<int> islands_;     // of a group, some more than once
};

}  // namespace engine
