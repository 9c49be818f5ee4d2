/// The exact solution, for small scenes: the reference for the other methods (second seed, 'one
/// way').
///   equalities      A lambda = wanted, factored as L D L^T
///   contacts        lambda >= 0, A lambda - wanted >= 0, one of them 0: an active set of rows that
///                   push; a row that would pull is removed, one that would sink is added
///   friction        sticks as two more equalities while inside its cone, else it slides along its
///                   boundary against the slip
/// Rows that depend on others (the fourth corner of a box, a joint that closes a loop) make A
/// singular: then an orthogonal decomposition gives the solution of least |lambda|, or, for
/// contradicting rows, the least-squares solution. It is never NaN.
#pragma once
#include <optional>

#include "engine/solver/global_rows.h"

namespace engine {

/// Maximum for one island (solver/islands.h). Factors are dense: time grows with the cube of the
/// rows, and a thousand take seconds.
constexpr int kMostDirectRows = 1000;

/// Sets `g.force`, island by island. Null if an island has more than kMostDirectRows rows.
std::optional<DirectReport> solveDirect(GlobalRows& g, const Constraints& c, int bodies);

}  // namespace engine
