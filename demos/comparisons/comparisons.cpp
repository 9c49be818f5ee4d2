#include "demos/comparisons/comparisons.h"

namespace demos {

const std::vector<Comparison>& builtinComparisons() {
    static const std::string seed = "solver.preset=seed";
    static const std::vector<Comparison> all = {
        {"clamping",
         "clamp the total impulse, not the correction: an excess is otherwise never taken back",
         "stack",
         2.8,
         "penetration",
         {{"the total is clamped", {seed}},
          {"the correction is clamped", {seed, "solver.accumulate=false"}}}},
        {"caching",
         "start from the last step's impulses: ten sweeps then carry a stack that otherwise sinks",
         "stack",
         2.8,
         "penetration",
         {{"impulses kept", {seed}}, {"from 0 every step", {seed, "solver.warm_start=false"}}}},
        {"nudges",
         "Baumgarte's correction becomes velocity and throws the ball up; nudges do not",
         "overlap",
         2.0,
         "speed",
         {{"nudges", {seed}},
          {"Baumgarte, 0.2", {seed, "solver.nudges=0", "solver.baumgarte=0.2"}}}},
        {"pgs",
         "projected Gauss-Seidel on forces and sequential impulses give the same sums",
         "chain",
         4.0,
         "separation",
         {{"sequential impulses", {seed, "solver.type=impulses"}},
          {"PGS, a = B lambda", {seed, "solver.type=pgs"}},
          {"PGS, A written out", {seed, "solver.type=pgs-matrix"}}}},
        {"sweeps",
         "more sweeps carry more weight",
         "pyramid",
         3.0,
         "penetration",
         {{"1 sweep", {seed, "solver.sweeps=1"}},
          {"4 sweeps", {seed, "solver.sweeps=4"}},
          {"16 sweeps", {seed, "solver.sweeps=16"}}}},
        {"substeps",
         "at equal cost, cutting the step beats sweeping it: sixteen sweeps either way",
         "chain",
         4.0,
         "separation",
         {{"1 sub-step, 16 sweeps",
           {seed, "solver.substeps=1", "solver.sweeps=16", "solver.nudges=16"}},
          {"4 sub-steps, 4 sweeps",
           {seed, "solver.substeps=4", "solver.sweeps=4", "solver.nudges=4"}},
          {"16 sub-steps, 1 sweep",
           {seed, "solver.substeps=16", "solver.sweeps=1", "solver.nudges=1"}}}},
        {"presets",
         "a tonne on a kilogram: the textbook method lets it sink, the presets of films hold it",
         "heavy-on-light",
         4.0,
         "penetration",
         {{"seed", {seed}},
          {"fast", {"solver.preset=fast"}},
          {"steady", {"solver.preset=steady"}}}},
    };
    return all;
}

const Comparison* comparisonCalled(const std::string& name) {
    for (const Comparison& comparison : builtinComparisons())
        if (comparison.name == name) return &comparison;
    return nullptr;
}

}  // namespace demos
