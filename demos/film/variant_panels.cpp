#include "demos/film/variant_panels.h"

#include <fmt/format.h>

#include <utility>

namespace demos {

std::vector<Panel> panelsOf(const std::vector<Variant>& variants) {
    std::vector<Panel> panels;
    for (const Variant& variant : variants) {
        Panel panel;
        panel.scene = variant.scene;
        panel.settings = fmt::format("{}", fmt::join(variant.settings, " "));
        panel.scene.title = variant.label;
        panel.scene.sections.clear();
        panels.push_back(std::move(panel));
    }
    return panels;
}

}  // namespace demos
