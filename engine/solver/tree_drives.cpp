#include "engine/solver/tree_drives.h"

#include <cmath>

#include "engine/solver/drives.h"

namespace engine {
namespace {

/// At most this many columns, and at most this many solves of a joint for them: then bodies are swept.
constexpr int kMostColumns = 24, kMostSolves = 512;
constexpr int kRounds = 8, kSweeps = 4;  // a round: sweeps, and all rows inside their bounds at once
constexpr double kSolved = 1e-9;         // m/s or rad/s
constexpr double kStuck = 1e-12;         // of K: the tree holds the coordinate, and only round-off is left
constexpr double kDependent = 1e-9;      // of a diagonal: a spring and a motor may hold the same coordinate

bool areTooMany(int columns, int joints) { return columns > kMostColumns || columns * joints > kMostSolves; }

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
                systems_[used].tree = tree, systems_[used].group = group, systems_[used].always = 0;
                ++used;
            }
            inSystem_[drive] = 1;
            System& s = systems_[systemOfTree_[tree]];
            for (int i = 0; i < c.drives[drive].count; ++i) {
                const DriveRow& row = c.drives[drive].rows[i];
                s.rows.push_back({});
                s.rows.back().drive = drive, s.rows.back().row = i;
                s.always += row.kind == DriveKind::spring || (row.kind == DriveKind::limit && isHeld(row)) ? 1 : 0;
            }
        }
    systems_.resize(used);
    byGroup_.sort(static_cast<int>(used), groups, [&](int i) { return systems_[i].group; });
}

bool TreeDrives::System::canMove(int row) const {
    return rows[row].softness > 0.0 || at(row, row) > kStuck * rows[row].k;
}

void TreeDrives::begin(int group, const JointTrees& trees) {
    for (const int i : byGroup_.of(group)) {
        System& s = systems_[i];
        s.columns = 0, s.tooMany = areTooMany(s.always, trees.jointsOf(s.tree));
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
        x.k = drive.alongOf(row).k;
        x.lambda = row.lambda, x.low = row.low, x.high = row.high, x.softness = row.softness;
    }
}

bool TreeDrives::addColumn(System& s, int row, const Constraints& c, JointTrees& trees) {
    if (areTooMany(s.columns + 1, trees.jointsOf(s.tree))) return false;
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
        if (x.isAtBound() || !(x.k > 0.0)) continue;
        if (x.column < 0 && !addColumn(s, i, c, trees)) {
            s.tooMany = true;
            continue;
        }
        if (!s.canMove(i)) continue;
        const double k = larger(s.at(i, i), 0.0) + x.softness;
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
        if (x.column >= 0 && x.low < x.lambda && x.lambda < x.high && s.canMove(i)) inside_.push_back(i);
    }
}

/// A x = -w by elimination; a row that depends on the others is left out.
void TreeDrives::eliminate(const System& s) {
    const int n = static_cast<int>(inside_.size());
    const auto a = [&](int i, int k) -> double& { return matrix_[i * n + k]; };
    matrix_.resize(n * n), x_.resize(n);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) a(i, k) = s.at(inside_[i], inside_[k]);
        a(i, i) += s.rows[inside_[i]].softness;
        x_[i] = -s.rows[inside_[i]].w;
    }
    for (int p = 0; p < n; ++p) {
        if (!(a(p, p) > kDependent * (s.at(inside_[p], inside_[p]) + s.rows[inside_[p]].softness))) a(p, p) = 0.0;
        for (int i = p + 1; i < n && a(p, p) > 0.0; ++i) {
            const double share = a(i, p) / a(p, p);
            for (int k = p + 1; k < n; ++k) a(i, k) -= share * a(p, k);
            x_[i] -= share * x_[p];
        }
    }
    for (int p = n - 1; p >= 0; --p) {
        for (int k = p + 1; k < n; ++k) x_[p] -= a(p, k) * x_[k];
        x_[p] = a(p, p) > 0.0 ? x_[p] / a(p, p) : 0.0;
    }
}

void TreeDrives::solveInside(System& s) {
    findInside(s);
    const int n = static_cast<int>(inside_.size());
    if (n < 2) return;
    eliminate(s);
    double share = 1.0;
    for (int i = 0; i < n; ++i) {
        const Unknown& x = s.rows[inside_[i]];
        const double room = (x_[i] > 0.0 ? x.high : x.low) - x.lambda;
        if (!std::isfinite(x_[i])) return;
        if (std::abs(x_[i]) > 0.0) share = smaller(share, room / x_[i]);
    }
    for (int i = 0; i < n; ++i) change(s, inside_[i], share * x_[i]);
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
        correction.add((larger(s.at(i, i), 0.0) + x.softness) * lambda, lambda);
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

void TreeDrives::solve(int group, bool moved, Constraints& c, JointTrees& trees, std::span<Velocity> v,
                       Correction& correction) {
    response_.resize(v.size());
    for (const int i : c.drivesByGroup.of(group)) {
        if (inSystem_[i]) continue;
        sweepDrive(c.drives[i], v, correction);
        moved = true;
    }
    for (const int i : byGroup_.of(group)) {
        System& s = systems_[i];
        if (moved) trees.solveTree(s.tree, v);
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
