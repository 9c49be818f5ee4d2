#include "engine/solver/pgs_matrix.h"

namespace engine {
namespace {

/// A row that acts on a movable body.
struct Hold {
    int row;
    bool ofB;
};

std::vector<std::vector<Hold>> holdsByBody(const GlobalRows& g, int bodies) {
    std::vector<std::vector<Hold>> holds(bodies);
    for (int i = 0; i < g.count(); ++i) {
        const GlobalRow& row = g.rows[i];
        if (row.row.massA > 0.0) holds[row.a].push_back({i, false});
        if (row.row.massB > 0.0) holds[row.b].push_back({i, true});
    }
    return holds;
}

}  // namespace

Eigen::SparseMatrix<double, Eigen::RowMajor> systemMatrix(const GlobalRows& g, int bodies) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const std::vector<Hold>& holds : holdsByBody(g, bodies))
        for (const Hold& i : holds)
            for (const Hold& k : holds)
                entries.emplace_back(
                    i.row, k.row,
                    couplingThrough(g.rows[i.row].row, i.ofB, g.rows[k.row].row, k.ofB));
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(g.count(), g.count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

SweepReport PgsMatrix::sweep() {
    const auto residual = [this](int i) {
        double sum = g_.wanted[i];
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(matrix_, i); it; ++it)
            sum -= it.value() * g_.force[it.col()];
        return sum;
    };
    return sweepRows(g_, residual, [](int, double) {});
}

}  // namespace engine
