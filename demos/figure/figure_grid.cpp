#include "demos/figure/figure_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/look/type.h"
#include "demos/text/stop.h"
#include "render/corners.h"
#include "render/encode/png.h"

namespace demos {
namespace {

constexpr double kLeastWidth = 20.0;  // mm of a picture: room for "t = 10.00 s"
constexpr int kMostColumns = 6;
constexpr double kMostPixels = 134'217'728.0;  // 512 MB of RGBA, as for a strip

int gapOf(const Paper& paper) {
    return std::max(static_cast<int>(std::lround(kGapPoints * paper.pixelsPerPoint())), 2);
}

}  // namespace

void checkLayout(const StripLayout& layout, const Paper& paper) {
    const double pixels = static_cast<double>(layout.width) * layout.height;
    const bool fits = layout.picture.width >= 16 && layout.picture.height >= 16 &&
                      layout.height <= render::kLargestSide && pixels <= kMostPixels;
    if (fits) return;
    const bool small = layout.picture.width < 16 || layout.picture.height < 16;
    throw Stop(
        Exit::usage,
        fmt::format("--width {:g}mm at {} dpi makes a figure of {}x{} pixels of {} pictures of "
                    "{}x{}; {}",
                    paper.width, paper.dpi, layout.width, layout.height, layout.moments,
                    layout.picture.width, layout.picture.height,
                    small ? "they need 16 a side: use a larger --width or fewer pictures"
                          : "at most 16384 a side and 134 million in all: use a smaller --dpi"));
}

int figureColumns(int pictures, const Paper& paper) {
    const double gap = paper.millimetresOf(gapOf(paper));
    const int most =
        std::clamp(static_cast<int>((paper.width + gap) / (kLeastWidth + gap)), 1, kMostColumns);
    const int rows = (pictures + most - 1) / most;
    return (pictures + rows - 1) / rows;
}

StripLayout figureLayout(int pictures, int columns, PictureSize ratio, const Paper& paper,
                         int lines) {
    StripLayout layout;
    layout.moments = pictures;
    layout.columns = columns > 0 ? std::min(columns, pictures) : figureColumns(pictures, paper);
    layout.rows = (pictures + layout.columns - 1) / layout.columns;
    layout.gap = gapOf(paper);
    layout.margin = 0;
    layout.width = paper.pixels();
    layout.lines = lines;
    if (lines > 0) layout.label = letterPixels(kLabelPoints, paper.pixelsPerPoint());
    layout.picture.width =
        std::max((layout.width - (layout.columns - 1) * layout.gap) / layout.columns, 1);
    layout.picture.height = std::max(
        static_cast<int>(std::lround(1.0 * layout.picture.width * ratio.height / ratio.width)), 1);
    layout.height =
        layout.rows * (layout.picture.height + layout.labelRoom() + layout.gap) - layout.gap;
    checkLayout(layout, paper);
    return layout;
}

std::vector<std::string> labelLines(const std::string& text, const StripLayout& layout) {
    return render::brokenText(text, layout.label, static_cast<float>(layout.picture.width));
}

std::string panelLetter(int panel) {
    return fmt::format("({})", static_cast<char>('a' + panel % 26));
}

}  // namespace demos
