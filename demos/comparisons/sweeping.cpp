#include "demos/comparisons/sweeping.h"

#include <algorithm>

namespace demos {
namespace {

constexpr std::size_t kMostPanels = 16;

std::vector<std::string> shortLabels(const Variation& variation) {
    const std::size_t dot = variation.key.find_last_of('.');
    const std::string name =
        dot == std::string::npos ? variation.key : variation.key.substr(dot + 1);
    std::vector<std::string> labels;
    for (const std::string& value : variation.values) labels.push_back(name + " = " + value);
    return labels;
}

}  // namespace

Sweeping sweepingOf(const SweepOptions& options) {
    const Variation variation = rangeFrom(options.over, "--over");
    const std::optional<Shard> read = options.dryRun ? std::nullopt : options.shard;
    return {variation.key,
            variantsOf(options, combinations({variation}), shortLabels(variation), "--over", read)};
}

std::vector<Variant> spread(const std::vector<Variant>& variants) {
    std::vector<Variant> chosen;
    const std::size_t count = std::min(variants.size(), kMostPanels);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(variants[count == 1 ? 0 : i * (variants.size() - 1) / (count - 1)]);
    return chosen;
}

}  // namespace demos
