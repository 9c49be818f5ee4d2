/// The exact solution, for small scenes: the ground truth of the others (second seed, 'one way').
///   equalities      A lambda = wanted, factored as L D L^T
///   contacts        lambda >= 0, A lambda - wanted >= 0, one of them 0: an active set of rows that
///                   push; a row that would have to pull is let go, one that would sink is taken in
///   friction        sticks as two more equalities while its cone holds it, slides along the cone's
///   edge
///                   against the slip otherwise
/// Rows that follow from others (the fourth corner of a box, a joint that closes a loop) make A
/// singular: then the solution of least |lambda| is taken, by an orthogonal decomposition; where
/// rows contradict each other, the one that misses them by the least squares. It is never NaN.
#pragma once
#include <optional>

#include "engine/solver/global_rows.h"

namespace engine {

/// Of one island (solver/islands.h). Dense factors: time grows with the cube of the rows, and a
/// thousand take seconds already.
constexpr int kMostDirectRows = 1000;

/// Sets `g.force`, island by island. Nothing where one has more than kMostDirectRows rows.
std::optional<DirectReport> solveDirect(GlobalRows& g, const Constraints& c, int bodies);

}  // namespace engine
