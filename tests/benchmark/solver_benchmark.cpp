// Nanoseconds per row and sweep: sequential impulses against projected Gauss-Seidel on forces, in
// Catto's form and with the matrix written out (mission 31). Stacks of ten boxes, four points and
// twelve rows per contact. Times one sweep, and the preparation of each method before its first sweep.
#include <benchmark/benchmark.h>

#include "engine/solver/impulses.h"
#include "engine/solver/pgs.h"
#include "engine/solver/pgs_matrix.h"

namespace {

using namespace engine;

constexpr double kStep = 1.0 / 60.0;
constexpr int kHeight = 10;  // boxes per stack

struct Problem {
    Constraints constraints;
    std::vector<Velocity> velocities;
    JointTrees trees;
    Settings settings = Settings::seed();

    explicit Problem(int bodies) : velocities(bodies + 1) {
        const InverseMass still, box{1.0, 6.0 * Mat3::Identity()};
        for (int i = 1; i <= bodies; ++i) {
            velocities[i].linear = {0.01 * (i % 7), -9.81 * kStep, 0.01 * (i % 5)};
            const bool lowest = (i - 1) % kHeight == 0;
            addContact(lowest ? 0 : i - 1, i, lowest ? still : box, box);
        }
        for (int i = 0; i < bodies; ++i) constraints.order.push_back(i);
        beginSolving(constraints, velocities, settings, kStep);
    }

    void addContact(int a, int b, const InverseMass& massA, const InverseMass& massB) {
        Contact contact;
        contact.a = a, contact.b = b, contact.count = 4, contact.friction = 0.6;
        ContactGeometry points[4];
        for (int i = 0; i < 4; ++i) {
            const double x = i % 2 ? 0.5 : -0.5, z = i / 2 ? 0.5 : -0.5;
            points[i] = {{x, 0.5, z}, {x, -0.5, z}, 0.0};
        }
        constraints.contacts.push_back(makeContactConstraint(contact, points, massA, massB));
    }

    int rows() const { return 12 * static_cast<int>(constraints.contacts.size()); }
};

void countRows(benchmark::State& state, const Problem& problem) {
    state.counters["row"] = benchmark::Counter(
        static_cast<double>(problem.rows()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void impulses(benchmark::State& state) {
    Problem problem(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            sweep(problem.constraints, problem.trees, problem.velocities, problem.settings));
    countRows(state, problem);
}

template <class Method>
void forces(benchmark::State& state) {
    Problem problem(static_cast<int>(state.range(0)));
    GlobalRows rows = globalRows(problem.constraints, problem.velocities, problem.settings, kStep);
    Method method(rows, static_cast<int>(problem.velocities.size()));
    for (auto _ : state) benchmark::DoNotOptimize(method.sweep());
    countRows(state, problem);
}

/// The preparation before the first sweep.
template <class Method>
void preparation(benchmark::State& state) {
    Problem problem(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        GlobalRows rows =
            globalRows(problem.constraints, problem.velocities, problem.settings, kStep);
        Method method(rows, static_cast<int>(problem.velocities.size()));
        benchmark::DoNotOptimize(method);
    }
    countRows(state, problem);
}

BENCHMARK(impulses)->Name("sweep/impulses")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(forces<Pgs>)->Name("sweep/pgs")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(forces<PgsMatrix>)->Name("sweep/pgs-matrix")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(preparation<Pgs>)->Name("before/pgs")->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(preparation<PgsMatrix>)->Name("before/pgs-matrix")->Arg(10)->Arg(100)->Arg(1000);

}  // namespace

BENCHMARK_MAIN();
