#include "engine/solver/tree_drives.h"

#include <Eigen/Cholesky>

#include "engine/solver/drives.h"

namespace engine {
namespace {

/// Columns of a system: beyond this, or this many times the joints of the tree, a sweep over bodies costs less.
constexpr int kMostColumns = 24, kMostSolves = 512;
constexpr int kRounds = 8, kSweeps = 4;  // a round: sweeps, and all rows inside their bounds at once
constexpr double kSolved = 1e-9;         // m/s or rad/s
constexpr double kRaised = 1e-9;         // of A's diagonal: a spring and a motor may hold the same coordinate

using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostColumns, kMostColumns>;
using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostColumns, 1>;

}  // namespace

void TreeDrives::sort(const Constraints& c, const JointTrees& trees, int groups) {
    std::size_t used = 0;
    systemOfTree_.assign(trees.treeCount(), -1);
    inSystem_.assign(c.drives.size(), 0);
    for (int group = 0; group < groups; ++group)
        for (const int drive : c.drivesByGroup.of(group)) {
            const int tree = trees.exactTreeOf(c.drives[drive].joint);
            if (tree < 0) continue;
            if (systemOfTree_[tree] < 0) {
                systemOfTree_[tree] = static_cast<int>(used);
                if (used == systems_.size()) systems_.emplace_back();
                systems_[used].rows.clear();
                systems_[used].tree = tree, systems_[used].group = group;
                ++used;
            }
            inSystem_[drive] = 1;
            for (int row = 0; row < c.drives[drive].count; ++row)
                systems_[systemOfTree_[tree]].rows.push_back({.drive = drive, .row = row});
        }
    systems_.resize(used);
    byGroup_.sort(static_cast<int>(used), groups, [&](int i) { return systems_[i].group; });
}

void TreeDrives::begin() {
    for (System& s : systems_) {
        s.columns = 0, s.tooMany = false;
        s.a.clear(), s.changes.clear(), s.impulses.clear();
        for (Unknown& x : s.rows) x.column = -1;
    }
}

void TreeDrives::read(System& s, const Constraints& c, std::span<const Velocity> v) const {
    for (Unknown& x : s.rows) {
        const JointDrive& drive = c.drives[x.drive];
        const DriveRow& row = drive.rows[x.row];
        const double rate = row.sign * velocityAlong(drive.alongOf(row).j, v[drive.a], v[drive.b]);
        x.w = rate + row.bias + row.softness * row.lambda;
        x.lambda = row.lambda, x.low = row.low, x.high = row.high, x.softness = row.softness;
    }
}

bool TreeDrives::addColumn(System& s, int row, const Constraints& c, JointTrees& trees) {
    const int count = s.columns + 1;
    if (count > kMostColumns || count * trees.jointsOf(s.tree) > kMostSolves) return false;
    const JointDrive& own = c.drives[s.rows[row].drive];
    const DriveRow& from = own.rows[s.rows[row].row];
    apply(own.alongOf(from), from.sign, response_[own.a], response_[own.b]);
    trees.respond(s.tree, response_, s.impulses);
    s.rows[row].column = s.columns++;
    for (const Unknown& x : s.rows) {
        const JointDrive& drive = c.drives[x.drive];
        const DriveRow& to = drive.rows[x.row];
        s.a.push_back(to.sign * velocityAlong(drive.alongOf(to).j, response_[drive.a], response_[drive.b]));
    }
    trees.eachBody(s.tree, [&](int body) {
        s.changes.push_back(response_[body]);
        response_[body] = {};
    });
    return true;
}

void TreeDrives::change(System& s, int row, double lambda) {
    s.rows[row].lambda += lambda;
    s.rows[row].w += lambda * s.rows[row].softness;
    const double* a = s.a.data() + s.rows[row].column * s.rows.size();
    for (Unknown& x : s.rows) x.w += lambda * *a++;
}

double TreeDrives::sweepOnce(System& s, const Constraints& c, JointTrees& trees) {
    double worst = 0.0;
    for (int i = 0; i < static_cast<int>(s.rows.size()); ++i) {
        Unknown& x = s.rows[i];
        if (x.isAtBound()) continue;
        if (x.column < 0 && !addColumn(s, i, c, trees)) {
            s.tooMany = true;
            continue;
        }
        const double k = s.at(i, i) + x.softness;
        if (!(k > 0.0)) continue;
        const double lambda = clamped(x.lambda - x.w / k, x.low, x.high) - x.lambda;
        change(s, i, lambda);
        worst = larger(worst, std::abs(k * lambda));
    }
    return worst;
}

void TreeDrives::findInside(const System& s) {
    inside_.clear();
    for (int i = 0; i < static_cast<int>(s.rows.size()); ++i) {
        const Unknown& x = s.rows[i];
        if (x.column >= 0 && x.low < x.lambda && x.lambda < x.high && s.at(i, i) > 0.0) inside_.push_back(i);
    }
}

void TreeDrives::solveInside(System& s) {
    findInside(s);
    const int n = static_cast<int>(inside_.size());
    if (n < 2) return;
    Block a(n, n);
    Numbers w(n);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) a(i, k) = s.at(inside_[i], inside_[k]);
        a(i, i) += s.rows[inside_[i]].softness + kRaised * a(i, i);
        w[i] = s.rows[inside_[i]].w;
    }
    const Numbers lambda = a.ldlt().solve(-w);
    double share = lambda.allFinite() ? 1.0 : 0.0;
    for (int i = 0; i < n; ++i) {
        const Unknown& x = s.rows[inside_[i]];
        const double room = (lambda[i] > 0.0 ? x.high : x.low) - x.lambda;
        if (std::abs(lambda[i]) > 0.0) share = smaller(share, room / lambda[i]);
    }
    for (int i = 0; i < n && share > 0.0; ++i) change(s, inside_[i], share * lambda[i]);
}

void TreeDrives::write(System& s, Constraints& c, JointTrees& trees, std::span<Velocity> v,
                       Correction& correction) const {
    for (int i = 0; i < static_cast<int>(s.rows.size()); ++i) {
        const Unknown& x = s.rows[i];
        if (x.column < 0) continue;
        JointDrive& drive = c.drives[x.drive];
        DriveRow& row = drive.rows[x.row];
        const double lambda = clamped(x.lambda, x.low, x.high) - row.lambda;
        if (lambda == 0.0) continue;
        row.lambda += lambda;
        book(drive, row, lambda);
        applyColumn(s, i, lambda, trees, v);
        correction.add((s.at(i, i) + x.softness) * lambda, lambda);
    }
}

void TreeDrives::applyColumn(const System& s, int row, double lambda, JointTrees& trees, std::span<Velocity> v) const {
    const std::size_t column = s.rows[row].column;
    const Velocity* change = s.changes.data() + column * (s.changes.size() / s.columns);
    trees.eachBody(s.tree, [&](int body) {
        v[body].linear += lambda * change->linear, v[body].angular += lambda * change->angular;
        ++change;
    });
    const std::size_t each = s.impulses.size() / s.columns;
    trees.bookResponse(s.tree, std::span(s.impulses).subspan(column * each, each), lambda);
}

void TreeDrives::solve(int group, bool others, Constraints& c, JointTrees& trees, std::span<Velocity> v,
                       Correction& correction) {
    response_.resize(v.size());
    for (const int i : c.drivesByGroup.of(group))
        if (!inSystem_[i]) sweepDrive(c.drives[i], v, correction);
    for (const int i : byGroup_.of(group)) {
        System& s = systems_[i];
        if (others) trees.solveTree(s.tree, v);
        read(s, c, v);
        double worst = 1.0;
        for (int round = 0; round < kRounds && worst > kSolved && !s.tooMany; ++round) {
            if (round > 0) solveInside(s);
            for (int k = 0; k < kSweeps && worst > kSolved; ++k) worst = sweepOnce(s, c, trees);
        }
        write(s, c, trees, v, correction);
        if (!s.tooMany) continue;
        for (std::size_t k = 0; k < s.rows.size(); ++k)
            if (k == 0 || s.rows[k].drive != s.rows[k - 1].drive) sweepDrive(c.drives[s.rows[k].drive], v, correction);
    }
}

}  // namespace engine
