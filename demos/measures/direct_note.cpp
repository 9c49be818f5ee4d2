#include "demos/measures/direct_note.h"

#include <fmt/format.h>

namespace demos {

void DirectNote::look(const Stage& stage) {
    const engine::DirectReport& direct = stage.world.report().direct;
    for (const engine::JointId id : direct.redundant)
        for (std::size_t i = 0; i < stage.joints.size(); ++i)
            if (stage.joints[i] == id) redundant_.insert(stage.scene.joints[i].name);
    contradictions_ += direct.contradiction;
    notFound_ += !direct.found;
}

std::vector<std::string> DirectNote::lines() const {
    std::vector<std::string> lines;
    if (!redundant_.empty())
        lines.push_back(fmt::format(
            "direct: redundant joint{} '{}': others hold the same; solved with the least impulses",
            redundant_.size() == 1 ? "" : "s", fmt::join(redundant_, "', '")));
    if (contradictions_ > 0)
        lines.push_back(
            fmt::format("direct: constraints contradicted each other in {} steps; satisfied "
                        "as closely as possible (least squares)",
                        contradictions_));
    if (notFound_ > 0)
        lines.push_back(
            fmt::format("direct: no consistent set of contacts in {} steps; sweeps were used "
                        "instead",
                        notFound_));
    return lines;
}

}  // namespace demos
