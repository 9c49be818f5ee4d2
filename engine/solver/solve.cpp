#include "engine/solver/solve.h"

#include "engine/solver/drives.h"
#include "engine/solver/impulses.h"
#include "engine/solver/methods.h"
#include "engine/solver/prepare_contacts.h"

namespace engine {
namespace {

constexpr double kSinks = 0.1;            // of the bodies' thickness, in a step
constexpr int kMoreSweeps = 4;            // times the usual sweeps, until they sink less
constexpr double kMuchLeft = 0.5;         // m/s, of a residual: see fresh_start.h
constexpr double kMuchLeftOfJoined = 0.25;  // m/s or rad/s: joined_start.h
/// Of a net, in a step and in a sub-step: what these leave, five times as many hardly reduce.
constexpr int kSweepsOfNet = 32, kFewestOfNet = 4;

/// Merges sweep i of a group with those of other groups.
void merge(std::vector<SweepReport>& report, std::size_t i, const SweepReport& swept) {
    if (report.size() <= i) report.emplace_back();
    report[i].residual = larger(report[i].residual, swept.residual);
    report[i].delta += swept.delta;
}

/// Solved by conjugate gradients: all rows are without bounds, as there are no contacts, limits or motors.
bool isConjugate(const Solver& s, int group) {
    return s.groups.hasJoints(group) && !s.groups.isTouched(group) && s.trees.isNet(group) &&
           s.constraints.drivesByGroup.of(group).empty();
}

/// A group's contacts, if they are not in lanes.
std::span<const int> rowsOf(const Solver& s, int group) {
    const std::span<const int> order = s.constraints.order;
    return order.subspan(s.firstOfGroup[group], s.firstOfGroup[group + 1] - s.firstOfGroup[group]);
}

/// The joints' part of a sweep; velocities are exchanged with lanes before and after.
SweepReport sweepJoints(Solver& s, int group, std::span<Velocity> v) {
    const std::span<const int> shared = s.groups.jointedBodies(group);
    if (s.lanes) s.wide.give(v, shared);
    const SweepReport swept = sweepJoints(s.constraints, s.trees, s.treeDrives, group, v);
    if (s.lanes) s.wide.take(v, shared);
    return swept;
}

SweepReport sweepContacts(Solver& s, int group, std::span<Velocity> v, const Settings& settings) {
    return s.lanes ? s.wide.sweep(group)
                   : sweepContacts(s.constraints, rowsOf(s, group), v, settings);
}

bool isTurnOf(const Solver& s, int group, const Bodies& bodies) { return bodies.acts[s.groups.bodyOf(group)]; }

/// A structure at rest that needs n sub-steps, more than usual, because it is tall or heavy on light, takes
/// n / 2 sweeps at least: what two of them leave over makes a column of 30 sway for ever. `step`: s.
int leastAtRest(const Solver& s, int group, const Settings& settings, double step) {
    const int substeps = static_cast<int>(step / s.groups.span(group) + 0.5);
    const int tall = substeps > settings.substeps ? substeps / 2 : 0;
    return smaller(larger(settings.minSweeps, tall), settings.sweeps);
}

int mostOfNet(const Solver& s, int group, const Settings& settings, double step) {
    const int substeps = static_cast<int>(step / s.groups.span(group) + 0.5);
    return smaller(larger(kSweepsOfNet / substeps, kFewestOfNet), settings.sweeps);
}

SweepLimits limitsOf(const Solver& s, int group, const Settings& settings, double step) {
    SweepLimits limits{settings.minSweeps, settings.minSweeps, settings.sweeps, settings.sweeps,
                       settings.tolerance};
    if (solvedAtOnce(s, group)) {
        limits.most = smaller(settings.sweeps, 1);
    } else if (isConjugate(s, group)) {
        limits.most = limits.fewest + mostOfNet(s, group, settings, step);
    } else if (s.groups.moving(group)) {
        limits.usual = smaller(settings.movingSweeps, settings.sweeps);
    } else if (s.groups.atRest(group)) {
        limits.least = leastAtRest(s, group, settings, step);
        limits.most *= settings.restFactor;
        limits.tolerance /= settings.restFactor;
        limits.usual = limits.most;
    }
    if (s.groups.isTouched(group) && settings.tolerance > 0.0) {
        limits.bearable = kSinks * s.groups.thickness(group) / step;
        limits.most = larger(limits.most, kMoreSweeps * settings.sweeps);
    }
    return limits;
}

/// Sweeps a group until it is satisfied. Returns the last residual.
double sweepGroup(Solver& s, int group, std::span<Velocity> v, const Settings& settings,
                  const SweepLimits& limits, std::size_t& next, std::vector<SweepReport>& report) {
    const bool joints = s.groups.hasJoints(group), atOnce = solvedAtOnce(s, group);
    const std::size_t first = next;
    double residual = 0.0;
    const auto satisfied = [&](const SweepReport& swept) {
        merge(report, next++, swept);
        residual = swept.residual;
        return limits.areEnough(static_cast<int>(next - first), residual);
    };
    if (s.lanes && s.wide.isLarge(group)) {
        for (const SweepReport& swept : s.wide.solveLarge(group, limits)) satisfied(swept);
        return residual;
    }
    const bool conjugate = isConjugate(s, group);  // after the fewest sweeps, which may be enough
    for (int i = 0; i < limits.most; ++i) {
        if (conjugate && i == limits.fewest) s.conjugate.begin(s.constraints, s.trees, group, v);
        SweepReport swept = joints ? sweepJoints(s, group, v) : SweepReport{};
        swept = together(swept, sweepContacts(s, group, v, settings));
        if (conjugate && i >= limits.fewest) s.conjugate.goOn(s.constraints, s.trees, group, v);
        if (atOnce) swept.residual = 0.0;
        if (satisfied(swept)) break;
    }
    return residual;
}

/// Whether an island's impulses have brought energy; they are taken back then.
bool startsAfresh(Solver& s, int group, Bodies& bodies) {
    if (isConjugate(s, group)) return false;
    if (s.groups.hasJoints(group)) return s.joined.takeBack(s, group, bodies);
    return s.lanes ? s.wide.takeBack(group)
                   : s.fresh.takeBack(s.constraints, rowsOf(s, group), s.groups, bodies.velocities);
}

void solveGroup(Solver& s, int group, Bodies& bodies, const Settings& settings, double step,
                std::size_t next, std::vector<SweepReport>& report) {
    const std::span<Velocity> v = bodies.velocities;
    const SweepLimits limits = limitsOf(s, group, settings, step);
    if (s.lanes && !s.wide.isLarge(group)) s.wide.warmStart(group);
    s.trees.setBiasRate(settings.baumgarte / s.groups.span(group));
    const double left = sweepGroup(s, group, v, settings, limits, next, report);
    const double much = s.groups.hasJoints(group) ? kMuchLeftOfJoined : kMuchLeft;
    if (left > much && startsAfresh(s, group, bodies))
        sweepGroup(s, group, v, settings, limits, next, report);
}

/// Starts joints, and contacts that are not in lanes, from their last impulses.
void begin(Solver& s, std::span<Velocity> v, const Settings& settings) {
    if (s.lanes && s.actingJoints.empty()) return;
    s.joined.begin(s, v);
    const std::span<const int> shared = s.groups.jointedBodies();
    if (s.lanes) s.wide.give(v, shared);
    warmStart(s.constraints, v, settings);
    for (const JointGroup& group : s.actingJoints) {
        s.treeDrives.begin(group.number, s.trees);
        s.trees.begin(group.number, settings.warmStart ? 1.0 : 0.0, v);
    }
    if (s.lanes) s.wide.take(v, shared);
}

/// Bounces, and biases of the rows.
void beginRows(Solver& s, std::span<Velocity> v, const Settings& settings, double h) {
    beginSolving(s.constraints, v, settings, h);
    if (!s.lanes) return;
    s.wide.begin(v, settings);
    for (const ContactImpact& impact : s.constraints.impacts.list())
        for (int i = 0; i < impact.contact.count; ++i)
            s.wide.setBounce(impact.number, i, impact.contact.rows[i].bounce, impact.ahead[i]);
    for (const RidingContact& riding : s.constraints.riding.list())
        s.wide.setLead(riding.number, riding.lead, riding.turn);
}

void solveIslands(Solver& s, Bodies& bodies, const Settings& settings, double h, StepReport& stepped) {
    const std::span<Velocity> v = bodies.velocities;
    std::vector<SweepReport>& report = stepped.sweeps;
    const bool touching = s.lanes ? !s.wide.empty() : !s.constraints.contacts.empty();
    if (s.constraints.joints.empty() && s.constraints.drives.empty() && !touching)
        return;  // all are asleep or in free flight
    beginRows(s, v, settings, h);
    const std::size_t first = report.size();
    begin(s, v, settings);
    for (int group = 0; group < s.groups.count(); ++group)
        if (isTurnOf(s, group, bodies))
            solveGroup(s, group, bodies, settings, h * stepped.substeps, first, report);
    if (s.lanes)
        s.wide.finish(v);
    else
        bookImpulses(s.constraints);
}

bool turnCarriers(const Solver& s, Bodies& bodies) {
    return s.constraints.riding.finish(bodies, [&](const RidingContact& c) {
        const Vec3 n = s.lanes ? s.wide.normalOf(c.number) : s.constraints.contacts[c.number].n;
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < c.count; ++i) {
            const PointImpulses got = impulsesOf(s, c.number, i);
            sum += got.normal * n + got.friction;
        }
        return sum;
    });
}

}  // namespace

bool solvedAtOnce(const Solver& s, int group) {
    return s.groups.hasJoints(group) && !s.groups.isTouched(group) && s.trees.isExact(group) &&
           s.constraints.jointsOutside.of(group).empty() &&
           s.constraints.drivesByGroup.of(group).empty();
}

void solveConstraints(Solver& solver, Bodies& bodies, const Settings& settings, double h,
                      StepReport& report) {
    const std::span<Velocity> v = bodies.velocities;
    solver.conjugate.prepare(bodies.inverseMasses);
    if (solver.byIsland)
        solveIslands(solver, bodies, settings, h, report);
    else
        solveByMethod(solver.constraints, solver.trees, v, settings, h, report);
    if (turnCarriers(solver, bodies))
        for (const JointGroup& group : solver.actingJoints) solver.trees.projectVelocities(group.number, v);
    for (const JointGroup& group : solver.actingJoints) solver.trees.keepStart(group.number, v);
    if (!solver.actingJoints.empty()) keepRates(solver.constraints, bodies);
}

}  // namespace engine
