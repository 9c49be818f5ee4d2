/// Step 3 of the loop: sequential impulses (first seed, 'The algorithm').
///   foreach constraint: start from the impulse of the last step, and apply it
///   while not satisfied: foreach constraint:
///       lambda = -(J v + b) / K;  total += lambda, clamped;  v += M^-1 J^T (what the total gained)
/// The seed starts from 0; it also asks for contact caching, which is to start from the last step.
#pragma once
#include "engine/solver/constraints.h"

namespace engine {

/// b of every contact row whose turn it is, in a world's sub-step of h (s), from the velocities before:
///   still apart by C     b = C / h: the gap may close, no more
///   overlapping          b = beta (C + slop) / h with Baumgarte; else 0, the nudges' business
///   bouncing             b = e (J v1) where it will touch at more than the bounce speed
void setBiases(Constraints& c, std::span<const Velocity> v, const Settings& settings, double h);

/// v += M^-1 J^T lambda of the last step; with warm starting off the totals are set to 0 instead.
void warmStart(Constraints& c, std::span<Velocity> v, const Settings& settings);

/// One sweep over everything; trees of joints are solved exactly, each at its place.
SweepReport sweep(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                  const Settings& settings);

/// Biases and bounces: what comes before the sweeps of every method.
void beginSolving(Constraints& c, std::span<Velocity> v, const Settings& settings, double h);

/// Adds a sub-step's impulses to the totals of the step: what comes after them.
void bookImpulses(Constraints& c);

/// 'While not satisfied': until the residual is small or the count is reached; a report per sweep.
template <class Sweep>
void sweepUntilSatisfied(const Settings& settings, std::vector<SweepReport>& report, Sweep sweep) {
    for (int i = 0; i < settings.sweeps; ++i) {
        report.push_back(sweep());
        const bool enough = i + 1 >= settings.minSweeps;
        if (enough && report.back().residual < settings.tolerance) break;
    }
}

/// All of the above.
void solveImpulses(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                   const Settings& settings, double h, std::vector<SweepReport>& report);

}  // namespace engine
