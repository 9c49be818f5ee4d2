#include "demos/film/film_strip.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/text/plural.h"
#include "demos/text/stop.h"
#include "render/encode/png.h"
#include "render/overlay.h"

namespace demos {
namespace {

constexpr int kMostColumns = 6;
constexpr double kMostPixels = 134'217'728.0;  // 512 MB of RGBA

/// Label height as a share of the strip's width (2 mm on 17 cm), and at least of a picture's.
constexpr double kLabelShare = 0.0115, kLeastLabelShare = 0.03;
constexpr int kSmallestLabel = 10;  // pixels

/// The fewest columns that need no more rows.
int evenColumns(int moments) {
    const int rows = (moments + kMostColumns - 1) / kMostColumns;
    return (moments + rows - 1) / rows;
}

int labelHeight(int stripWidth, int pictureWidth) {
    const double pixels = std::max(kLabelShare * stripWidth, kLeastLabelShare * pictureWidth);
    return std::max(static_cast<int>(pixels), kSmallestLabel);
}

std::uint8_t level(float channel) { return static_cast<std::uint8_t>(channel * 255.0f + 0.5f); }

/// How to make the strip smaller.
const char* adviceFor(const StripLayout& layout) {
    if (layout.moments == 1) return "";
    return layout.width > render::kLargestSide ? " or fewer --columns" : " or fewer pictures";
}

void checkSides(const StripLayout& layout) {
    const int side = std::max(layout.width, layout.height);
    const double pixels = static_cast<double>(layout.width) * layout.height;
    if (side <= render::kLargestSide && pixels <= kMostPixels) return;
    throw Stop(
        Exit::usage,
        fmt::format("{} of {}x{} in one picture of {}x{} pixels; at most {} a side and 134 "
                    "million in all; use a smaller --size{}",
                    plural(layout.moments, "picture"), layout.picture.width, layout.picture.height,
                    layout.width, layout.height, render::kLargestSide, adviceFor(layout)));
}

}  // namespace

StripLayout stripLayout(int moments, int columns, PictureSize picture, bool labels) {
    StripLayout layout;
    layout.moments = moments;
    layout.picture = picture;
    layout.columns = columns > 0 ? std::min(columns, moments) : evenColumns(moments);
    layout.rows = (moments + layout.columns - 1) / layout.columns;
    layout.margin = layout.gap = std::max(picture.width / 80, 2);
    layout.width = layout.gap + layout.columns * (picture.width + layout.gap);
    if (labels) layout.label = labelHeight(layout.width, picture.width);
    layout.height = layout.gap + layout.rows * (picture.height + layout.labelRoom() + layout.gap);
    checkSides(layout);
    return layout;
}

render::Image stripPaper(const StripLayout& layout, const render::Color& ground) {
    render::Image paper{layout.width, layout.height, {}};
    paper.pixels.resize(std::size_t{4} * layout.width * layout.height);
    const std::uint8_t pixel[] = {level(ground.r), level(ground.g), level(ground.b),
                                  level(ground.a)};
    for (std::size_t i = 0; i < paper.pixels.size(); i += 4)
        std::copy_n(pixel, 4, paper.pixels.data() + i);
    return paper;
}

void placePicture(const StripLayout& layout, int moment, const render::Image& picture,
                  render::Image& paper) {
    const int left = layout.left(moment), top = layout.top(moment);
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(picture.at(0, row), 4 * picture.width, paper.at(left, top + row));
}

void placeLines(const StripLayout& layout, int moment, const std::vector<std::string>& lines,
                render::Anchor anchor, const render::Color& ink, render::Image& paper) {
    const float wide = static_cast<float>(layout.picture.width);
    const float pixels = static_cast<float>(layout.label);
    const float x = static_cast<float>(layout.left(moment)) +
                    (anchor == render::Anchor::middle ? 0.5f * wide : 0.0f);
    float y = static_cast<float>(layout.top(moment) + layout.picture.height) + 1.15f * pixels;
    for (const std::string& line : lines) {
        render::drawLabel(paper, line, {x, y}, anchor, pixels, ink);
        y += static_cast<float>(layout.lineHeight());
    }
}

void placeMoment(const StripLayout& layout, int moment, const render::Image& picture,
                 const std::string& label, const render::Color& ink, render::Image& paper) {
    placePicture(layout, moment, picture, paper);
    if (layout.label == 0) return;
    const float wide = static_cast<float>(picture.width);
    float pixels = static_cast<float>(layout.label);
    pixels = std::min(pixels, pixels * wide / std::max(render::textWidth(label, pixels), 1.0f));
    const float baseline = static_cast<float>(layout.top(moment) + picture.height) + 1.15f * pixels;
    const float middle = static_cast<float>(layout.left(moment)) + 0.5f * wide;
    render::drawLabel(paper, label, {middle, baseline}, render::Anchor::middle, pixels, ink);
}

}  // namespace demos
