// The panel of numbers, with energy as a bar.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/scene/solver_words.h"
#include "demos/snapshot/frame_parts.h"
#include "render/palette.h"

namespace demos {
namespace {

/// With four digits: 264.8 kJ.
std::string joules(double energy) {
    const double size = std::abs(energy);
    if (size >= 1e6) return fmt::format("{:.4g} MJ", energy / 1e6);
    if (size >= 1e3) return fmt::format("{:.4g} kJ", energy / 1e3);
    if (size >= 1.0 || size == 0.0) return fmt::format("{:.4g} J", energy);
    return fmt::format("{:.3g} mJ", energy * 1e3);
}

/// The bar shows shares of the largest energy so far, above the lowest potential so far.
void addEnergy(const Moment& moment, std::vector<render::PlateRow>& rows) {
    const engine::Energy energy = moment.stage.world.energy();
    const render::Color moving = render::paletteColor(1), resting = render::paletteColor(0);
    const double stored = energy.potential + energy.elastic;
    const double lowest = std::min(moment.history.lowestPotential, energy.potential);
    const double largest = std::max(moment.history.largestEnergy, energy.total()) - lowest;
    const auto share = [&](double part) {
        return largest > 0.0 ? static_cast<float>(part / largest) : 0.0f;
    };
    rows.push_back({"energy", joules(energy.total())});
    rows.back().bar = {{share(energy.kinetic), moving}, {share(stored - lowest), resting}};
    rows.push_back({"kinetic", joules(energy.kinetic), render::Swatch::dot, moving});
    rows.push_back({"potential", joules(stored), render::Swatch::dot, resting});
}

}  // namespace

void addStats(const Moment& moment, render::Frame& frame) {
    const Stage& stage = moment.stage;
    const engine::StepReport& report = stage.world.report();
    const engine::ErrorReport errors = stage.world.errors();
    const engine::Settings& settings = stage.world.settings();
    render::Plate plate;
    const auto row = [&](const char* name, std::string value) {
        plate.rows.push_back({name, std::move(value)});
    };
    row("time", fmt::format("{:.3f} s", moment.time));
    row("step", fmt::format("{}", report.step));
    row("bodies", fmt::format("{}", stage.bodiesNow()));
    if (settings.sleeping) row("asleep", fmt::format("{}", report.asleep));
    row("contacts", fmt::format("{}", errors.contacts));
    row("solver", fmt::format("{} {}", stage.scene.preset, wordOf(settings.method)));
    row("sub-steps", fmt::format("{}", report.step > 0 ? report.substeps : settings.substeps));
    row("sweeps", fmt::format("{}", report.sweeps.size()));
    row("penetration", fmt::format("{:.2f} mm", 1e3 * errors.penetration));
    if (!stage.joints.empty()) row("separation", fmt::format("{:.2f} mm", 1e3 * errors.separation));
    addEnergy(moment, plate.rows);
    frame.plates.push_back(std::move(plate));
}

}  // namespace demos
