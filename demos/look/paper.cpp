#include "demos/look/paper.h"

#include <fmt/format.h>

#include <cmath>

#include "demos/text/stop.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kLeastHeight = 5.0;  // mm: a lower figure shows nothing

}  // namespace

int Paper::pixelsOf(double millimetres) const {
    return static_cast<int>(std::lround(millimetres / 25.4 * dpi));
}

PictureSize figureSize(const Paper& paper, PictureSize ratio) {
    const int width = paper.pixels();
    const double height = static_cast<double>(width) * ratio.height / ratio.width;
    if (height > render::kLargestSide)
        throw Stop(
            Exit::usage,
            fmt::format("--width {:g}mm at {} dpi and --size {}x{} make a figure of {}x{:.0f} "
                        "pixels; at most {} per side; use a smaller --dpi",
                        paper.width, paper.dpi, ratio.width, ratio.height, width, height,
                        render::kLargestSide));
    if (height < paper.pixelsOf(kLeastHeight))
        throw Stop(Exit::usage,
                   fmt::format("--width {:g}mm and --size {}x{} make a figure {:.1f} mm high; it "
                               "must be at least {:g} mm high: use --size {}x{:.0f}",
                               paper.width, ratio.width, ratio.height, height * 25.4 / paper.dpi,
                               kLeastHeight, ratio.width,
                               std::ceil(kLeastHeight / paper.width * ratio.width)));
    return {width, static_cast<int>(std::lround(height))};
}

}  // namespace demos
