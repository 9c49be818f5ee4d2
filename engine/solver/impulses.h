/// Step 3 of the loop: sequential impulses (first seed, 'The algorithm').
///   foreach constraint: start from the impulse of the last step, and apply it
///   while not satisfied: foreach constraint:
///       lambda = -(J v + b) / K;  total += lambda, clamped;  v += M^-1 J^T (what the total gained)
/// The seed starts from 0, but also requires contact caching, which starts from the last step.
#pragma once
#include "engine/solver/constraints.h"
#include "engine/solver/tree_drives.h"

namespace engine {

/// Sets b of every acting contact row, in a sub-step of the world of h (s), from the velocities before:
///   still apart by C     b = C / h: the gap may close, but no more
///   overlapping          b = beta (C + slop) / h with Baumgarte; else 0, left to the nudges
///   bouncing             b = e (J v1) where it will touch at more than the bounce speed
void setBiases(Constraints& c, std::span<const Velocity> v, const Settings& settings, double h);

/// v += M^-1 J^T lambda of the last step; without warm starting, the totals are set to 0 instead.
void warmStart(Constraints& c, std::span<Velocity> v, const Settings& settings);

/// One sweep over the joints, trees exactly, of all or of a group; or over contacts in this order.
SweepReport sweepJoints(Constraints& c, JointTrees& trees, std::span<Velocity> v);
SweepReport sweepJoints(Constraints& c, JointTrees& trees, TreeDrives& drives, int group, std::span<Velocity> v);
SweepReport sweepContacts(Constraints& c, std::span<const int> order, std::span<Velocity> v,
                          const Settings& settings);

/// Both sweeps as one report.
SweepReport together(const SweepReport& a, const SweepReport& b);

/// One sweep over all constraints.
SweepReport sweep(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                  const Settings& settings);

/// Biases and bounces, before the sweeps of every method.
void beginSolving(Constraints& c, std::span<Velocity> v, const Settings& settings, double h);

/// Adds the impulses of a sub-step to the totals of the step, after the sweeps.
void bookImpulses(Constraints& c);

/// 'While not satisfied': sweeps until the residual is small or the count is reached; one report per sweep.
template <class Sweep>
void sweepUntilSatisfied(const Settings& settings, std::vector<SweepReport>& report, Sweep sweep) {
    for (int i = 0; i < settings.sweeps; ++i) {
        report.push_back(sweep());
        const bool enough = i + 1 >= settings.minSweeps;
        if (enough && report.back().residual < settings.tolerance) break;
    }
}

/// A complete solve: all of the above.
void solveImpulses(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                   const Settings& settings, double h, std::vector<SweepReport>& report);

}  // namespace engine
