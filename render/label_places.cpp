#include "render/label_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/coverage.h"

namespace render {
namespace {

/// Whether a stroke meets the box: a point of it is within the box, made wider by `half`.
bool meets(const Box& box, const Vec2& from, const Vec2& to, float half) {
    // Cut the stroke to the box's range of x, then of y (Liang and Barsky).
    float begin = 0.0f, end = 1.0f;
    const Vec2 low(box.x - half, box.y - half);
    const Vec2 high(box.x + box.width + half, box.y + box.height + half);
    for (int axis = 0; axis < 2; ++axis) {
        const float way = to[axis] - from[axis];
        if (std::abs(way) < 1e-6f) {
            if (from[axis] < low[axis] || from[axis] > high[axis]) return false;
            continue;
        }
        const float one = (low[axis] - from[axis]) / way, two = (high[axis] - from[axis]) / way;
        begin = std::max(begin, std::min(one, two));
        end = std::min(end, std::max(one, two));
    }
    return begin <= end;
}

}  // namespace

LabelPlaces::LabelPlaces(const Image& image, const Frame& frame, const View& view,
                         const CornerLayout& corners)
    : image_(image), corners_(corners) {
    const auto isBeside = [](const Label& label) { return label.beside; };
    if (std::none_of(frame.labels.begin(), frame.labels.end(), isBeside)) return;
    const float scale = overlayScale(frame.look, image.width, image.height);
    for (const Arrow& arrow : frame.arrows) addStroke(view, arrow.from, arrow.to, 3.0f * scale);
    for (const Line& line : frame.lines)
        addStroke(view, line.from, line.to, 0.5f * line.pixels * scale);
    for (const Marker& marker : frame.markers)
        addStroke(view, marker.position, marker.position, marker.pixels * scale);
}

void LabelPlaces::addStroke(const View& view, const Vec3& from, const Vec3& to, float half) {
    const Projected a = project(view, from, image_.width, image_.height);
    const Projected b = project(view, to, image_.width, image_.height);
    if (a.depth > 0 && b.depth > 0) strokes_.push_back({{a.x, a.y}, {b.x, b.y}, half});
}

bool LabelPlaces::isFree(const Box& box) const {
    const auto overlaps = [&](const Box& other) { return other.overlaps(box); };
    return box.x >= 0.0f && box.y >= 0.0f &&
           box.x + box.width <= static_cast<float>(image_.width) &&
           box.y + box.height <= static_cast<float>(image_.height) && corners_.isFree(box) &&
           std::none_of(taken_.begin(), taken_.end(), overlaps);
}

bool LabelPlaces::coversMarks(const Box& box) const {
    return std::any_of(strokes_.begin(), strokes_.end(), [&](const Stroke& stroke) {
        return meets(box, stroke.from, stroke.to, stroke.half);
    });
}

bool LabelPlaces::takeOver(Box& box, float most) {
    const float y = box.y;
    for (const float shift : {0.0f, -box.height, box.height}) {
        if (std::abs(shift) > most) continue;
        box.y = y + shift;
        if (!isFree(box)) continue;
        taken_.push_back(box);
        return true;
    }
    return false;
}

/// Takes the free place nearest to `corner`, which may move along `way` (pixels) to both sides.
bool LabelPlaces::takeNear(Box& box, const Vec2& corner, const Vec2& way) {
    constexpr int kPlaces = 8;  // to each side
    for (int i = 0; i <= 2 * kPlaces; ++i) {
        const auto turn = static_cast<float>(i % 2 ? (i + 1) / 2 : -i / 2);
        box.x = corner.x() + turn * way.x();
        box.y = corner.y() + turn * way.y();
        if (!isFree(box) || coversMarks(box)) continue;
        taken_.push_back(box);
        return true;
    }
    return false;
}

bool LabelPlaces::takeOutside(Box& box, const std::vector<Vec3>& points, const View& view) {
    Vec2 low(1e6f, 1e6f), high = -low;
    for (const Vec3& point : points) {
        const Projected at = project(view, point, image_.width, image_.height);
        if (!(at.depth > 0)) return false;
        low = low.cwiseMin(Vec2(at.x, at.y));
        high = high.cwiseMax(Vec2(at.x, at.y));
    }
    const float gap = 0.6f * box.height, middle = box.x + 0.5f * box.width;
    const Vec2 up(0.0f, 0.6f * box.height), along(0.6f * box.height, 0.0f);
    const Vec2 left(low.x() - gap - box.width, box.y), right(high.x() + gap, box.y);
    const bool leftFirst = middle - low.x() < high.x() - middle;
    return takeNear(box, leftFirst ? left : right, up) ||
           takeNear(box, leftFirst ? right : left, up) ||
           takeNear(box, {middle - 0.5f * box.width, low.y() - gap - box.height}, along) ||
           takeNear(box, {middle - 0.5f * box.width, high.y() + gap}, along);
}

bool LabelPlaces::takeBeside(Box& box) {
    constexpr int kDirections = 16;
    const Vec2 middle(box.x + 0.5f * box.width, box.y + 0.5f * box.height);
    for (const float gap : {0.3f, 0.7f, 1.2f, 2.0f, 3.0f})
        for (int i = 0; i < kDirections; ++i) {
            // From the upper right, in turn to both sides.
            const int turn = i % 2 ? (i + 1) / 2 : -i / 2;
            const float angle = 2.0f * std::numbers::pi_v<float> *
                                (0.125f + static_cast<float>(turn) / kDirections);
            const Vec2 way(std::cos(angle), -std::sin(angle));
            const Vec2 at = middle + Vec2(way.x() * (0.5f * box.width + gap * box.height),
                                          way.y() * (0.5f + gap) * box.height);
            box.x = at.x() - 0.5f * box.width;
            box.y = at.y() - 0.5f * box.height;
            if (!isFree(box) || coversMarks(box)) continue;
            taken_.push_back(box);
            return true;
        }
    return false;
}

}  // namespace render
