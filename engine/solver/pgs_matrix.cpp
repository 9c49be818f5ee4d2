#include "engine/solver/pgs_matrix.h"

namespace engine {
namespace {

/// Where a row takes hold of a movable body.
struct Hold {
    int row;
    bool ofB;
};

template <class Real>
std::vector<std::vector<Hold>> holdsByBody(const GlobalRows<Real>& g, int bodies) {
    std::vector<std::vector<Hold>> holds(bodies);
    for (int i = 0; i < g.count(); ++i) {
        const GlobalRow<Real>& row = g.rows[i];
        if (row.row.massA > Real(0)) holds[row.a].push_back({i, false});
        if (row.row.massB > Real(0)) holds[row.b].push_back({i, true});
    }
    return holds;
}

}  // namespace

template <class Real>
Eigen::SparseMatrix<Real, Eigen::RowMajor> systemMatrix(const GlobalRows<Real>& g, int bodies) {
    std::vector<Eigen::Triplet<Real>> entries;
    for (const std::vector<Hold>& holds : holdsByBody(g, bodies))
        for (const Hold& i : holds)
            for (const Hold& k : holds)
                entries.emplace_back(
                    i.row, k.row,
                    couplingThrough(g.rows[i.row].row, i.ofB, g.rows[k.row].row, k.ofB));
    Eigen::SparseMatrix<Real, Eigen::RowMajor> matrix(g.count(), g.count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

template <class Real>
SweepReport PgsMatrix<Real>::sweep() {
    const auto residual = [this](int i) {
        Real sum = g_.wanted[i];
        for (typename Eigen::SparseMatrix<Real, Eigen::RowMajor>::InnerIterator it(matrix_, i); it;
             ++it)
            sum -= it.value() * g_.force[it.col()];
        return sum;
    };
    return sweepRows(g_, residual, [](int, Real) {});
}

template Eigen::SparseMatrix<float, Eigen::RowMajor> systemMatrix(const GlobalRows<float>&, int);
template Eigen::SparseMatrix<double, Eigen::RowMajor> systemMatrix(const GlobalRows<double>&, int);
template class PgsMatrix<float>;
template class PgsMatrix<double>;

}  // namespace engine
