/// Projected Gauss-Seidel with an explicit system matrix, the approach that the first seed begins
/// with and argues against.
///   A = J M^-1 J^T, sparse: A_ij is nonzero where the rows i and j share a movable body
///   foreach row: lambda_i += (wanted_i - sum_j A_ij lambda_j) / A_ii, clamped
/// Assembly costs the square of the number of rows per body, and every row then reads as many
/// entries as it has neighbours; the other forms read two bodies (tests/benchmark has the figures).
#pragma once
#include <Eigen/SparseCore>

#include "engine/solver/global_rows.h"

namespace engine {

/// A without the rows' softness; row-major, columns ascending.
Eigen::SparseMatrix<double, Eigen::RowMajor> systemMatrix(const GlobalRows& g, int bodies);

class PgsMatrix {
public:
    /// Works on the forces of `rows`, which must outlive this object.
    PgsMatrix(GlobalRows& rows, int bodies) : g_(rows), matrix_(systemMatrix(rows, bodies)) {}
    SweepReport sweep();

private:
    GlobalRows& g_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;
};

}  // namespace engine
