#include "demos/charts/curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/overlay.h"

namespace demos {
namespace {

/// Adds the lowest and highest of points[first, last), in their order.
void addExtremes(const std::vector<render::Point>& points, std::size_t first, std::size_t last,
                 std::vector<render::Point>& kept) {
    std::size_t low = first, high = first;
    for (std::size_t i = first; i < last; ++i) {
        if (points[i].y < points[low].y) low = i;
        if (points[i].y > points[high].y) high = i;
    }
    kept.push_back(points[std::min(low, high)]);
    if (low != high) kept.push_back(points[std::max(low, high)]);
}

/// Neighbours that share their mean.
struct Block {
    float sum = 0.0f;
    int count = 0;
    float mean() const { return sum / static_cast<float>(count); }
};

/// The nearest non-decreasing sequence (pool adjacent violators; Barlow et al. 1972).
std::vector<float> neverFalling(const std::vector<float>& values) {
    std::vector<Block> blocks;
    for (const float value : values) {
        Block block{value, 1};
        while (!blocks.empty() && blocks.back().mean() >= block.mean()) {
            block = {block.sum + blocks.back().sum, block.count + blocks.back().count};
            blocks.pop_back();
        }
        blocks.push_back(block);
    }
    std::vector<float> result;
    for (const Block& block : blocks)
        result.insert(result.end(), static_cast<std::size_t>(block.count), block.mean());
    return result;
}

}  // namespace

std::vector<render::Point> thinned(const std::vector<render::Point>& points) {
    std::vector<render::Point> kept;
    const auto column = [&](std::size_t i) { return std::floor(points[i].x); };
    for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
        while (last < points.size() && column(last) == column(first)) ++last;
        if (last - first <= 2)
            kept.insert(kept.end(), &points[first], &points[first] + (last - first));
        else
            addExtremes(points, first, last, kept);
    }
    return kept;
}

/// With y_i = z_i + i * spacing, the labels are apart exactly if z is non-decreasing.
std::vector<float> separated(const std::vector<float>& wanted, float spacing, float low,
                             float high) {
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    std::vector<float> z;
    for (std::size_t i = 0; i < order.size(); ++i)
        z.push_back(wanted[order[i]] - static_cast<float>(i) * spacing);
    z = neverFalling(z);
    const float room = high - static_cast<float>(wanted.size()) * spacing + spacing;
    std::vector<float> result(wanted.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        result[order[i]] =
            std::clamp(z[i], low, std::max(low, room)) + static_cast<float>(i) * spacing;
    return result;
}

std::string fitted(const std::string& text, float pixels, float room) {
    if (text.empty() || render::textWidth(text, pixels) <= room) return text;
    for (std::size_t length = text.size() - 1; length > 0; --length) {
        if ((static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) continue;  // inside a letter
        const std::string shorter = text.substr(0, length) + "…";
        if (render::textWidth(shorter, pixels) <= room) return shorter;
    }
    return {};
}

std::string fittedName(const std::string& text, float pixels, float room) {
    if (render::textWidth(text, pixels) <= room) return text;
    std::vector<std::size_t> starts;  // of letters
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) starts.push_back(i);
    for (std::size_t kept = starts.size() - 1; kept >= 2; --kept) {
        const std::size_t head = (kept + 1) / 2, tail = kept / 2;
        const std::string shorter =
            text.substr(0, starts[head]) + "…" + text.substr(starts[starts.size() - tail]);
        if (render::textWidth(shorter, pixels) <= room) return shorter;
    }
    return fitted(text, pixels, room);
}

std::string withoutAsides(const std::string& text, float pixels, float room) {
    std::string title = text;
    while (render::textWidth(title, pixels) > room) {
        const std::size_t comma = title.rfind(", "), bracket = title.rfind(" (");
        const std::size_t cut = comma == std::string::npos     ? bracket
                                : bracket == std::string::npos ? comma
                                                               : std::max(comma, bracket);
        if (cut == std::string::npos || cut == 0) break;
        title.resize(cut);
    }
    return title;
}

}  // namespace demos
