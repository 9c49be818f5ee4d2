/// A run in a few numbers with their history, for comparisons.
#pragma once
#include <string>
#include <vector>

#include "demos/snapshot/player.h"

namespace demos {

/// A measure of a run; smaller is better for all of them.
struct Measure {
    const char* name;  // column, and name for --plot
    const char* unit;
    const char* meaning;
};
/// drift, speed, penetration, separation, energy, residual, sweeps, ms
const std::vector<Measure>& measures();
/// Its index in measures(), or -1.
int measureCalled(const std::string& name);
/// The names of all.
std::vector<std::string> measureWords();

struct Summary {
    std::vector<double> values;                // one per measure, for the whole run
    std::string diverged;                      // empty, or the line with the reason
    std::string failed;                        // failedLine() of the expectations, or empty
    std::vector<double> time;                  // s, of every step
    std::vector<std::vector<double>> history;  // per measure: one value per step
};

/// Measures a run during the simulation.
class SummaryRecorder {
public:
    /// `stage`: at time 0.
    explicit SummaryRecorder(const Stage& stage);
    /// Simulates one step and records it. Throws Stop (diverged) like the player.
    void step(Player& player);
    /// The summary of the run so far.
    Summary summary(const std::string& diverged = {}) const;

private:
    void look(const Stage& stage, double ms);
    double largestMove(const Stage& stage) const;

    double startEnergy_;        // J
    std::vector<Vec3> start_;   // m, by body
    Summary summary_;           // without its values
};

/// Simulates the scene once, without pictures. Throws Stop (interrupted) on a signal.
Summary summarize(const SceneDescription& scene);

}  // namespace demos
