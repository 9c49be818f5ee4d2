#include "demos/play/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "demos/text/complaints.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

constexpr std::size_t kMostLines = 5;
constexpr double kThin = 10.0;  // kg/m^3; foams have more

struct Overlap {
    std::string a, b;
    double depth = 0.0;  // m
};

std::vector<Overlap> overlapsOf(const Stage& stage) {
    std::map<std::pair<engine::BodyId, engine::BodyId>, double> depths;
    for (const engine::ContactState& contact : stage.world.contacts()) {
        double& depth = depths[{contact.a, contact.b}];
        depth = std::max(depth, contact.penetration);
    }
    std::vector<Overlap> overlaps;
    for (const auto& [pair, depth] : depths)
        if (depth > stage.world.settings().slop + 1e-9)
            overlaps.push_back({stage.nameOf(pair.first), stage.nameOf(pair.second), depth});
    std::ranges::stable_sort(overlaps, std::greater(), &Overlap::depth);
    return overlaps;
}

void addOverlaps(const Stage& stage, std::vector<std::string>& lines) {
    const std::vector<Overlap> overlaps = overlapsOf(stage);
    for (const Overlap& o : overlaps) {
        if (lines.size() == kMostLines) break;
        lines.push_back(fmt::format("{}: '{}' and '{}' overlap by {:.3g} m at the start; they are "
                                    "pushed apart",
                                    stage.scene.name, o.a, o.b, o.depth));
    }
    if (overlaps.size() > kMostLines)
        lines.push_back(fmt::format("{}: and {} more pairs overlap", stage.scene.name,
                                    overlaps.size() - kMostLines));
}

/// A gas in which bodies of a gas may float.
bool hasThinMedium(const SceneDescription& scene) {
    return std::ranges::any_of(scene.forces, [](const ForceDescription& force) {
        const auto* medium = std::get_if<engine::Medium>(&force.def.kind);
        return medium && medium->density < kThin;
    });
}

/// 2.7 is likely meant in g/cm^3.
void addThinBodies(const SceneDescription& scene, std::vector<std::string>& lines) {
    if (hasThinMedium(scene)) return;
    std::vector<const BodyDescription*> thin;
    for (const BodyDescription& body : scene.bodies)
        if (body.def.kind == engine::BodyKind::dynamic && !body.def.mass &&
            body.def.material.density < kThin)
            thin.push_back(&body);
    if (thin.empty()) return;
    const std::string others =
        thin.size() == 1
            ? ""
            : fmt::format(" and {}", plural(thin.size() - 1, "other body", "other bodies"));
    lines.push_back(fmt::format("{}: '{}'{}: a density of {} kg/m^3 is that of a gas; water has "
                                "1000, steel 7800",
                                scene.name, thin.front()->name, others,
                                numberText(thin.front()->def.material.density)));
}

}  // namespace

std::vector<std::string> warningsAtStart(const Stage& stage) {
    std::vector<std::string> lines;
    addOverlaps(stage, lines);
    addThinBodies(stage.scene, lines);
    return lines;
}

}  // namespace demos
