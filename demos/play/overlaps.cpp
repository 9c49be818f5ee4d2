#include "demos/play/overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace demos {
namespace {

constexpr std::size_t kMostLines = 5;

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

}  // namespace

std::vector<std::string> overlapsAtStart(const Stage& stage) {
    const std::vector<Overlap> overlaps = overlapsOf(stage);
    std::vector<std::string> lines;
    for (const Overlap& o : overlaps) {
        if (lines.size() == kMostLines) break;
        lines.push_back(fmt::format("{}: '{}' and '{}' overlap by {:.3g} m at the start; they are "
                                    "pushed apart",
                                    stage.scene.name, o.a, o.b, o.depth));
    }
    if (overlaps.size() > kMostLines)
        lines.push_back(fmt::format("{}: and {} more pairs overlap", stage.scene.name,
                                    overlaps.size() - kMostLines));
    return lines;
}

}  // namespace demos
