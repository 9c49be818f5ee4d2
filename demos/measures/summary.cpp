#include "demos/measures/summary.h"

#include <algorithm>
#include <cmath>

#include "demos/measures/clock.h"
#include "demos/play/expect.h"
#include "demos/processes/signals.h"
#include "demos/snapshot/player.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

enum MeasurePlace { drift, speed, penetration, separation, energy, residual, sweeps, milliseconds };

double largest(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double largestSpeed(const Stage& stage) {
    double most = 0.0;
    for (const engine::BodyId body : stage.bodies)
        most = std::max(most, stage.world.velocity(body).norm());
    return most;
}

}  // namespace

const std::vector<Measure>& measures() {
    static const std::vector<Measure> all = {
        {"drift", "m", "largest horizontal way of a body, at the end"},
        {"speed", "m/s", "fastest body, at most"},
        {"penetration", "m", "deepest contact"},
        {"separation", "m", "widest joint"},
        {"energy", "J", "change since the start"},
        {"residual", "m/s", "left by the last sweep of a step, mean"},
        {"sweeps", "", "a step, mean"},
        {"ms", "ms", "processor time of a step, median"},
    };
    return all;
}

int measureCalled(const std::string& name) {
    for (std::size_t i = 0; i < measures().size(); ++i)
        if (name == measures()[i].name) return static_cast<int>(i);
    return -1;
}

std::vector<std::string> measureWords() {
    std::vector<std::string> names;
    for (const Measure& measure : measures()) names.emplace_back(measure.name);
    return names;
}

SummaryRecorder::SummaryRecorder(const Stage& stage) : startEnergy_(stage.world.energy().total()) {
    summary_.history.resize(measures().size());
    for (const engine::BodyId body : stage.bodies) start_.push_back(stage.world.pose(body).position);
}

void SummaryRecorder::step(Player& player) {
    const double before = processorTime();
    player.step();
    look(player.stage(), 1e3 * (processorTime() - before));
}

void SummaryRecorder::look(const Stage& stage, double ms) {
    const engine::StepReport& report = stage.world.report();
    const engine::ErrorReport errors = stage.world.errors();
    summary_.time.push_back(report.time);
    const double values[] = {largestMove(stage),
                             largestSpeed(stage),
                             errors.penetration,
                             errors.separation,
                             report.energy.total() - startEnergy_,
                             report.residual,
                             static_cast<double>(report.sweeps.size()),
                             ms};
    for (std::size_t i = 0; i < std::size(values); ++i) summary_.history[i].push_back(values[i]);
}

Summary SummaryRecorder::summary(const std::string& diverged) const {
    Summary summary = summary_;
    const auto& h = summary.history;
    summary.diverged = diverged;
    summary.values = {h[drift].empty() ? 0.0 : h[drift].back(),
                      largest(h[speed]),
                      largest(h[penetration]),
                      largest(h[separation]),
                      h[energy].empty() ? 0.0 : h[energy].back(),
                      mean(h[residual]),
                      mean(h[sweeps]),
                      median(h[milliseconds])};
    return summary;
}

double SummaryRecorder::largestMove(const Stage& stage) const {
    double most = 0.0;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        Vec3 move = stage.world.pose(stage.bodies[i]).position - start_[i];
        move.y() = 0.0;
        most = std::max(most, move.norm());
    }
    return most;
}

Summary summarize(const SceneDescription& scene) {
    Player player(scene, Overlays{.trails = false});
    SummaryRecorder recorder(player.stage());
    ExpectationChecker checker(player.stage());
    checker.look(player.stage());
    const long steps = std::max(std::lround(scene.seconds * scene.hz), 1L);
    for (long step = 1; step <= steps; ++step) {
        try {
            recorder.step(player);
            checker.look(player.stage());
        } catch (const Stop& stop) {
            if (stop.code() != Exit::diverged) throw;
            return recorder.summary(stop.what());
        }
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
    Summary summary = recorder.summary(player.incident());
    summary.failed = failedLine(checker.results());
    return summary;
}

}  // namespace demos
