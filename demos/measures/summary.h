/// A run in a few numbers, and how they went: what comparisons are made of.
#pragma once
#include <string>
#include <vector>

#include "demos/snapshot/player.h"

namespace demos {

/// What is measured of a run; every one is better when smaller.
struct Measure {
    const char* name;  // column, and word of --plot
    const char* unit;
    const char* meaning;
};
/// drift, speed, penetration, separation, energy, residual, sweeps, ms
const std::vector<Measure>& measures();
/// Its place in measures(), or -1.
int measureCalled(const std::string& name);
/// The names of all.
std::vector<std::string> measureWords();

struct Summary {
    std::vector<double> values;                // one per measure; of the whole run
    std::string diverged;                      // empty, or the line that says how
    std::vector<double> time;                  // s, of every step
    std::vector<std::vector<double>> history;  // per measure: a value a step
};

/// Measures a run while it plays.
class SummaryRecorder {
public:
    /// `stage`: at time 0.
    explicit SummaryRecorder(const Stage& stage);
    /// Plays one and looks at it. Throws Stop (diverged) as the player does.
    void step(Player& player);
    /// Of the run so far.
    Summary summary(const std::string& diverged = {}) const;

private:
    void look(const Stage& stage, double ms);
    double largestMove(const Stage& stage) const;

    double startEnergy_;        // J
    std::vector<Vec3> start_;   // m, by body
    Summary summary_;           // without its values
};

/// Plays the scene once, physics only. Throws Stop (interrupted) on a signal.
Summary summarize(const SceneDescription& scene);

}  // namespace demos
