#include "engine/solver/direct.h"

#include <Eigen/QR>
#include <algorithm>

#include "engine/solver/islands.h"
#include "engine/solver/pgs.h"
#include "engine/solver/pgs_matrix.h"

namespace engine {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Relative to a diagonal of 1. A row that elimination reduces to this is nearly a difference of
/// equals: a row of hinges between two banks holds some directions twice except for a little play,
/// and dividing by it gives huge impulses.
constexpr double kSingular = 1e-5;
constexpr double kMissed = 1e-3;     // of the right-hand side: a larger error is a contradiction
constexpr double kExact = 1e-12;   // of the largest value of its kind
constexpr int kMostChanges = 300;  // of the active set
constexpr int kMostSweeps = 5000;  // used if no set was found

/// A x = rhs for the active rows, scaled so that A's diagonal is 1.
class ActiveSystem {
public:
    ActiveSystem(const Matrix& a, std::vector<int> rows) : rows_(std::move(rows)) {
        const int n = static_cast<int>(rows_.size());
        scale_.resize(n);
        for (int i = 0; i < n; ++i) scale_[i] = 1.0 / std::sqrt(a(rows_[i], rows_[i]));
        scaled_.resize(n, n);
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k)
                scaled_(i, k) = scale_[i] * a(rows_[i], rows_[k]) * scale_[k];
        rank_ = n;
        if (n == 0) return;
        factors_.compute(scaled_);
        if (factors_.vectorD().minCoeff() > kSingular) return;
        leastNorm_.setThreshold(kSingular);
        leastNorm_.compute(scaled_);
        rank_ = static_cast<int>(leastNorm_.rank());
    }

    const std::vector<int>& rows() const { return rows_; }
    int rank() const { return rank_; }

    Vector solve(const Vector& rhs) {
        if (rows_.empty()) return rhs;
        const Vector scaledRhs = rhs.cwiseProduct(scale_);
        const Vector x = rank_ == static_cast<int>(rows_.size())
                             ? Vector(factors_.solve(scaledRhs))
                             : Vector(leastNorm_.solve(scaledRhs));
        missed_ = (scaled_ * x - scaledRhs).cwiseAbs().maxCoeff() >
                  kMissed * larger(scaledRhs.cwiseAbs().maxCoeff(), 1e-9);
        return x.cwiseProduct(scale_);
    }

    /// The last solution could not meet all rows.
    bool missed() const { return missed_; }

    /// Rows that depend on the others.
    std::vector<int> redundant() const {
        std::vector<int> list;
        if (rank_ == static_cast<int>(rows_.size())) return list;
        for (int i = rank_; i < static_cast<int>(rows_.size()); ++i)
            list.push_back(rows_[leastNorm_.colsPermutation().indices()[i]]);
        return list;
    }

private:
    std::vector<int> rows_;
    Vector scale_;
    Matrix scaled_;
    int rank_ = 0;
    bool missed_ = false;
    Eigen::LDLT<Matrix> factors_;
    Eigen::CompleteOrthogonalDecomposition<Matrix> leastNorm_;
};

/// Searches for the set of active rows.
class ActiveSet {
public:
    ActiveSet(GlobalRows& g, int bodies)
        : g_(g), wanted_(Eigen::Map<const Vector>(g.wanted.data(), g.count())), active_(g.count()) {
        a_ = systemMatrix(g, bodies);
        for (int i = 0; i < g.count(); ++i) {
            a_(i, i) += g.rows[i].softness;
            active_[i] = a_(i, i) > 0.0;
            g.force[i] = 0.0;
        }
        tolerance_ = kExact * larger(g.count() > 0 ? wanted_.cwiseAbs().maxCoeff() : 0.0, 1e-6);
    }

    /// True when a consistent set was found.
    bool search() {
        int least = g_.count() + 1, patience = 5;
        for (int change = 0; change < kMostChanges; ++change) {
            ActiveSystem system = solveActive();
            const std::vector<int> wrong = wrongRows();
            if (wrong.empty() && settleFriction(system)) return true;
            // Changes all wrong rows at once while that helps, then one at a time, which avoids
            // cycles.
            if (static_cast<int>(wrong.size()) < least) {
                least = static_cast<int>(wrong.size());
                patience = 5;
            } else if (patience > 0) {
                --patience;
            }
            for (const int i : wrong) {
                flip(i);
                if (patience == 0) break;
            }
        }
        return false;
    }

    DirectReport report(const Constraints& c) const {
        DirectReport report = report_;
        for (const int i : redundant_)
            if (g_.rows[i].joint >= 0)
                report.redundant.push_back({c.joints[g_.rows[i].joint].joint});
        std::sort(report.redundant.begin(), report.redundant.end());
        report.redundant.erase(std::unique(report.redundant.begin(), report.redundant.end()),
                               report.redundant.end());
        return report;
    }

private:
    Eigen::Map<Vector> lambda() { return {g_.force.data(), g_.count()}; }
    double slack(int i) const {  // (A lambda - wanted)_i, m/s^2
        return a_.row(i).dot(Eigen::Map<const Vector>(g_.force.data(), g_.count())) - wanted_[i];
    }

    ActiveSystem solveActive() {
        std::vector<int> rows;
        for (int i = 0; i < g_.count(); ++i)
            if (active_[i]) rows.push_back(i);
        ActiveSystem system(a_, std::move(rows));
        refill(system);
        return system;
    }

    /// Solves for the active forces, with the present sliding forces.
    void refill(ActiveSystem& system) {
        for (const int i : system.rows()) g_.force[i] = 0.0;
        const int n = static_cast<int>(system.rows().size());
        Vector rhs(n);
        for (int k = 0; k < n; ++k) rhs[k] = -slack(system.rows()[k]);
        const Vector x = system.solve(rhs);
        for (int k = 0; k < n; ++k) g_.force[system.rows()[k]] = x[k];
        report_.rows = n;
        report_.rank = system.rank();
        report_.contradiction = system.missed();
        redundant_ = system.redundant();
    }

    /// Rows that pull, sink, exceed their strength, or stick outside their cone.
    std::vector<int> wrongRows() const {
        std::vector<int> wrong;
        for (int i = 0; i < g_.count(); ++i) {
            const GlobalRow& row = g_.rows[i];
            if (a_(i, i) <= 0.0) continue;
            if (row.kind == RowKind::push) {
                const double scale = a_(i, i);
                const bool pulls = active_[i] && scale * g_.force[i] < -tolerance_;
                const bool sinks = !active_[i] && slack(i) < -tolerance_;
                if (pulls || sinks) wrong.push_back(i);
            } else if (row.kind == RowKind::hold) {
                if (active_[i] ? beyondStrength(i) : givesWay(i)) wrong.push_back(i);
            } else if (row.kind == RowKind::cone) {
                if (active_[i] && beyondCone(i)) wrong.push_back(i);
                ++i;
            }
        }
        return wrong;
    }

    bool beyondStrength(int i) const {
        return a_(i, i) * (std::abs(g_.force[i]) - g_.rows[i].most) > tolerance_;
    }
    /// At its maximum strength, though less is enough.
    bool givesWay(int i) const {
        return g_.force[i] > 0.0 ? slack(i) > tolerance_ : slack(i) < -tolerance_;
    }

    bool beyondCone(int i) const {
        const double pull =
            std::sqrt(g_.force[i] * g_.force[i] + g_.force[i + 1] * g_.force[i + 1]);
        return a_(i, i) * (pull - larger(g_.coneLimit(i), 0.0)) > tolerance_;
    }

    void flip(int i) {
        active_[i] = !active_[i];
        if (g_.rows[i].kind == RowKind::cone) {
            active_[i + 1] = active_[i];
            if (!active_[i]) hold(i, {g_.force[i], g_.force[i + 1]});
        } else if (!active_[i] && g_.rows[i].kind == RowKind::hold) {
            g_.force[i] = g_.force[i] > 0.0 ? g_.rows[i].most : -g_.rows[i].most;
        } else if (!active_[i]) {
            g_.force[i] = 0.0;
        }
    }

    /// Sets the force of a sliding or rolling pair, clamped to its cone.
    void hold(int i, Vec2 force) {
        const double limit = larger(g_.coneLimit(i), 0.0);
        if (force.norm() > limit) force *= limit / force.norm();
        g_.force[i] = force[0], g_.force[i + 1] = force[1];
    }

    /// Turns the sliding forces against the slip until they are stable; true when the active set is
    /// still consistent.
    bool settleFriction(ActiveSystem& system) {
        for (int turn = 0; turn < kMostChanges; ++turn) {
            double moved = 0.0;
            bool sticks = false;
            for (int i = 0; i < g_.count(); ++i) {
                if (g_.rows[i].kind != RowKind::cone) continue;
                if (!active_[i] && a_(i, i) > 0.0) moved = larger(moved, turnFriction(i, sticks));
                ++i;
            }
            if (sticks) return false;
            if (moved <= tolerance_) return wrongRows().empty();
            refill(system);
            if (!wrongRows().empty()) return false;
        }
        return false;
    }

    /// One step of the force against the slip. If it need not slide, makes it active and sets
    /// `sticks`.
    double turnFriction(int i, bool& sticks) {
        const Vec2 before(g_.force[i], g_.force[i + 1]);
        const double limit = larger(g_.coneLimit(i), 0.0);
        const Vec2 after = solveInCone(*g_.rows[i].mass, before, {slack(i), slack(i + 1)}, limit);
        if (after.norm() < limit * (1.0 - 1e-9)) {
            active_[i] = active_[i + 1] = true;
            sticks = true;
        }
        g_.force[i] = after[0], g_.force[i + 1] = after[1];
        return a_(i, i) * (after - before).norm();
    }

    GlobalRows& g_;
    Matrix a_;
    Vector wanted_;
    std::vector<char> active_;  // held at slack 0; of a cone row: sticking
    double tolerance_ = 0.0;    // m/s^2
    DirectReport report_;
    std::vector<int> redundant_;
};

DirectReport solveIsland(GlobalRows& g, const Constraints& c, int bodies) {
    ActiveSet set(g, bodies);
    const bool found = set.search();
    DirectReport report = set.report(c);
    report.found = found;
    if (found) return report;
    report.contradiction = false;  // unknown
    for (double& force : g.force)
        if (!std::isfinite(force)) force = 0.0;
    Pgs pgs(g, bodies);
    for (int i = 0; i < kMostSweeps && pgs.sweep().residual > kExact; ++i) {
    }
    return report;
}

void merge(const DirectReport& part, DirectReport& whole) {
    whole.rows += part.rows;
    whole.rank += part.rank;
    whole.redundant.insert(whole.redundant.end(), part.redundant.begin(), part.redundant.end());
    whole.contradiction = whole.contradiction || part.contradiction;
    whole.found = whole.found && part.found;
}

}  // namespace

std::optional<DirectReport> solveDirect(GlobalRows& g, const Constraints& c, int bodies) {
    std::vector<Island> islands = islandsOf(g, bodies);
    for (const Island& island : islands)
        if (island.rows.count() > kMostDirectRows) return std::nullopt;
    DirectReport report;
    std::fill(g.force.begin(), g.force.end(), 0.0);
    for (Island& island : islands) {
        merge(solveIsland(island.rows, c, bodies), report);
        for (int i = 0; i < island.rows.count(); ++i)
            g.force[island.places[i]] = island.rows.force[i];
    }
    return report;
}

}  // namespace engine
