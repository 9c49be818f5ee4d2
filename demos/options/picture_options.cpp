#include "demos/options/picture_options.h"

namespace demos {

Paper paperOf(const Options& options) { return {options.width.value_or(0.0), options.dpi}; }

std::string themeOf(const SceneDescription& scene, const Options& options) {
    if (!options.theme.empty()) return options.theme;
    const bool plain = scene.look.theme.empty() || scene.look.theme == "studio";
    if (options.width && plain) return "print";
    return plain ? "studio" : scene.look.theme;
}

}  // namespace demos
