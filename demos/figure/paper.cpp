#include "demos/figure/paper.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/stop.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kLeastHeight = 5.0;  // mm: less shows nothing

}  // namespace

int Paper::pixelsOf(double millimetres) const {
    return static_cast<int>(std::lround(millimetres / 25.4 * dpi));
}

Paper paperOf(const Options& options) { return {options.width.value_or(0.0), options.dpi}; }

PictureSize figureSize(const Paper& paper, PictureSize ratio) {
    const int width = paper.pixels();
    const double height = static_cast<double>(width) * ratio.height / ratio.width;
    if (height > render::kLargestSide)
        throw Stop(
            Exit::usage,
            fmt::format("--width {:g}mm at {} dpi and --size {}x{} make a figure of {}x{:.0f} "
                        "pixels; at most {} a side; use a smaller --dpi",
                        paper.width, paper.dpi, ratio.width, ratio.height, width, height,
                        render::kLargestSide));
    if (height < paper.pixelsOf(kLeastHeight))
        throw Stop(Exit::usage,
                   fmt::format("--width {:g}mm and --size {}x{} make a figure {:.1f} mm high; it "
                               "must be {:g} mm at least, --size {}x{:.0f}",
                               paper.width, ratio.width, ratio.height, height * 25.4 / paper.dpi,
                               kLeastHeight, ratio.width,
                               std::ceil(kLeastHeight / paper.width * ratio.width)));
    return {width, static_cast<int>(std::lround(height))};
}

std::string themeOf(const SceneDescription& scene, const Options& options) {
    if (!options.theme.empty()) return options.theme;
    const bool plain = scene.look.theme.empty() || scene.look.theme == "studio";
    if (options.width && plain) return "print";
    return plain ? "studio" : scene.look.theme;
}

}  // namespace demos
