#include "engine/solver/methods.h"

#include "engine/solver/direct.h"
#include "engine/solver/exact_velocities.h"
#include "engine/solver/impulses.h"
#include "engine/solver/pgs.h"
#include "engine/solver/pgs_matrix.h"

namespace engine {
namespace {

using Velocities = std::span<Velocity>;

/// The distance of the velocities that the present forces would give.
double distanceOf(const GlobalRows& g, Velocities v, const ExactVelocities& exact) {
    std::vector<Velocity> now(v.begin(), v.end());
    std::vector<double> impulses = g.force;
    for (double& lambda : impulses) lambda *= g.h;
    addAlongRows(g, impulses, now);
    return exact.distance(now);
}

template <class Method>
void solveByForces(Constraints& c, Velocities v, const Settings& settings, double h,
                   StepReport& report) {
    beginSolving(c, v, settings, h);
    GlobalRows g = globalRows(c, v, settings, h);
    const ExactVelocities exact(c, v, settings, h);
    Method method(g, static_cast<int>(v.size()));
    sweepUntilSatisfied(settings, report.sweeps, [&] {
        SweepReport swept = method.sweep();
        if (settings.compareExact) swept.distance = distanceOf(g, v, exact);
        return swept;
    });
    takeForces(g, c, v);
    bookImpulses(c);
}

/// Keeps the worst report of a step's sub-steps.
void keepWorst(const DirectReport& now, DirectReport& kept) {
    const auto badness = [](const DirectReport& r) {
        return (r.found ? 0 : 1 << 20) + (r.contradiction ? 1 << 19 : 0) + (r.rows - r.rank);
    };
    if (badness(now) >= badness(kept)) kept = now;
}

void solveDirectly(Constraints& c, Velocities v, const Settings& settings, double h,
                   StepReport& report) {
    beginSolving(c, v, settings, h);
    GlobalRows g = globalRows(c, v, settings, h);
    const std::optional<DirectReport> solved = solveDirect(g, c, static_cast<int>(v.size()));
    if (!solved) {
        report.trouble = Trouble::tooManyRows;
        return;
    }
    keepWorst(*solved, report.direct);
    double sum = 0.0;
    for (const double force : g.force) sum += std::abs(h * force);
    report.sweeps.push_back({0.0, sum, settings.compareExact ? 0.0 : -1.0});
    takeForces(g, c, v);
    bookImpulses(c);
}

}  // namespace

void solveByMethod(Constraints& c, JointTrees& trees, std::span<Velocity> v,
                      const Settings& settings, double h, StepReport& report) {
    switch (settings.method) {
        case Method::impulses:
            solveImpulses(c, trees, v, settings, h, report.sweeps);
            break;
        case Method::pgs:
            solveByForces<Pgs>(c, v, settings, h, report);
            break;
        case Method::pgsMatrix:
            solveByForces<PgsMatrix>(c, v, settings, h, report);
            break;
        case Method::direct:
            solveDirectly(c, v, settings, h, report);
            break;
    }
}

}  // namespace engine
