/// Projected Gauss-Seidel on forces, in Catto's form: the accelerations a = B lambda are updated
/// incrementally, with B = M^-1 J^T, so A is never formed.
///   a = B lambda
///   foreach row: lambda_i += (wanted_i - J_i a) / A_ii, clamped;  a += B_i (change of lambda_i)
/// With the same row order and bounds, h lambda equals the accumulated sequential impulses after
/// every sweep: a is the change of velocity they have made so far, divided by h. (First seed,
/// 'Comparison'; Catto 2005, 'Iterative Dynamics with Temporal Coherence', algorithm 3.)
#pragma once
#include "engine/solver/global_rows.h"

namespace engine {

class Pgs {
public:
    /// Works on the forces of `rows`, which must outlive this object.
    Pgs(GlobalRows& rows, int bodies);
    SweepReport sweep();

private:
    GlobalRows& g_;
    std::vector<Velocity> accelerations_;  // B lambda
};

}  // namespace engine
