#include "engine/solver/solve.h"

#include "engine/solver/drives.h"
#include "engine/solver/impulses.h"
#include "engine/solver/methods.h"

namespace engine {
namespace {

/// Merges sweep i of a group with those of other groups.
void merge(std::vector<SweepReport>& report, std::size_t i, const SweepReport& swept) {
    if (report.size() <= i) report.emplace_back();
    report[i].residual = larger(report[i].residual, swept.residual);
    report[i].delta += swept.delta;
}

/// The joints' part of a sweep; velocities are exchanged with the contacts before and after.
SweepReport sweepJoints(Solver& s, std::span<Velocity> v, const Settings& settings) {
    const std::span<const int> shared = s.wide.groups().jointedBodies();
    s.wide.give(v, shared);
    const SweepReport swept = sweep(s.constraints, s.trees, v, settings);
    s.wide.take(v, shared);
    return swept;
}

bool isTurnOf(const Solver& s, int group) {
    const bool joints = group == 0 && s.wide.groups().hasJoints();
    return joints ? s.constraints.jointStride > 0 : s.wide.acts(group);
}

void solveGroup(Solver& s, int group, std::span<Velocity> v, const Settings& settings,
                std::size_t first, std::vector<SweepReport>& report) {
    const bool joints = group == 0 && s.wide.groups().hasJoints();
    const bool atOnce = joints && solvedAtOnce(s);
    const int most = atOnce ? smaller(settings.sweeps, 1)
                     : s.wide.groups().moving(group)
                         ? smaller(settings.movingSweeps, settings.sweeps)
                         : settings.sweeps;
    if (s.wide.isLarge(group)) {
        std::size_t i = first;
        for (const SweepReport& swept :
             s.wide.solveLarge(group, {settings.minSweeps, most, settings.tolerance}))
            merge(report, i++, swept);
        return;
    }
    s.wide.warmStart(group);
    for (int i = 0; i < most; ++i) {
        SweepReport swept = joints ? sweepJoints(s, v, settings) : SweepReport{};
        const SweepReport contacts = s.wide.sweep(group);
        swept.residual = larger(swept.residual, contacts.residual);
        swept.delta += contacts.delta;
        if (atOnce) swept.residual = 0.0;
        merge(report, first + i, swept);
        if (i + 1 >= settings.minSweeps && swept.residual < settings.tolerance) return;
    }
}

void beginJoints(Solver& s, std::span<Velocity> v, const Settings& settings, double h) {
    if (s.constraints.jointStride == 0) return;
    const std::span<const int> shared = s.wide.groups().jointedBodies();
    s.wide.give(v, shared);
    warmStart(s.constraints, v, settings);
    s.trees.begin(settings.warmStart ? 1.0 : 0.0,
                  settings.baumgarte / (s.constraints.jointStride * h), v);
    s.wide.take(v, shared);
}

void solveIslands(Solver& s, std::span<Velocity> v, const Settings& settings, double h,
                  std::vector<SweepReport>& report) {
    if (s.constraints.joints.empty() && s.constraints.drives.empty() && s.wide.empty())
        return;  // all are asleep or in free flight
    beginSolving(s.constraints, v, settings, h);  // bounces, and biases of the joints
    s.wide.begin(v, settings);
    for (const ContactImpact& impact : s.constraints.impacts.list())
        for (int i = 0; i < impact.contact.count; ++i)
            s.wide.setBounce(impact.number, i, impact.contact.rows[i].bounce);
    const std::size_t first = report.size();
    beginJoints(s, v, settings, h);
    for (int group = 0; group < s.wide.groups().count(); ++group)
        if (isTurnOf(s, group)) solveGroup(s, group, v, settings, first, report);
    s.wide.finish(v);
}

}  // namespace

bool solvedAtOnce(const Solver& s) {
    const bool touched = s.lanes && !s.wide.groups().jointedBodies().empty();
    return !touched && solvedAtOnce(s.constraints, s.trees);
}

void solveConstraints(Solver& solver, std::span<Velocity> v, const Settings& settings, double h,
                      StepReport& report) {
    if (solver.lanes)
        solveIslands(solver, v, settings, h, report.sweeps);
    else
        solveByMethod(solver.constraints, solver.trees, v, settings, h, report);
    if (solver.constraints.jointStride == 0) return;
    solver.trees.keepStart(v);
    keepRates(solver.constraints, v);
}

}  // namespace engine
