#include "render/tile_set.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

constexpr float kFar = 1e9f;  // pixels

}  // namespace

TileSet::TileSet(int width, int height, int side)
    : width_(width),
      height_(height),
      side_(side),
      across_((width + side - 1) / side),
      down_((height + side - 1) / side),
      held_(static_cast<std::size_t>(across_) * down_) {}

void TileSet::add(const PixelRect& rect) {
    if (rect.empty()) return;
    const int x0 = std::max(rect.x0, 0), y0 = std::max(rect.y0, 0);
    const int x1 = std::min(rect.x1, width_), y1 = std::min(rect.y1, height_);
    for (int y = y0 / side_; y * side_ < y1; ++y)
        for (int x = x0 / side_; x * side_ < x1; ++x) addTile(x, y);
}

void TileSet::add(const TileSet& other) {
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] |= other.held_[i];
}

void TileSet::keepOnly(const TileSet& other) {
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] &= other.held_[i];
}

bool TileSet::touches(const PixelRect& rect) const {
    const int x0 = std::max(rect.x0, 0), y0 = std::max(rect.y0, 0);
    const int x1 = std::min(rect.x1, width_), y1 = std::min(rect.y1, height_);
    for (int y = y0 / side_; y * side_ < y1; ++y)
        for (int x = x0 / side_; x * side_ < x1; ++x)
            if (holdsTile(x, y)) return true;
    return false;
}

bool TileSet::touches(const TileSet& other) const {
    for (std::size_t i = 0; i < held_.size(); ++i)
        if (held_[i] && other.held_[i]) return true;
    return false;
}

bool TileSet::empty() const { return std::find(held_.begin(), held_.end(), 1) == held_.end(); }

double TileSet::share() const {
    const auto count = std::count(held_.begin(), held_.end(), 1);
    return held_.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(held_.size());
}

PixelRect TileSet::rectOf(int x, int y, int wide) const {
    return {x * side_, y * side_, std::min((x + wide) * side_, width_),
            std::min((y + 1) * side_, height_)};
}

std::vector<PixelRect> TileSet::rects() const {
    std::vector<PixelRect> rects;
    for (int y = 0; y < down_; ++y)
        for (int x = 0; x < across_; ++x) {
            if (!holdsTile(x, y)) continue;
            int wide = 1;
            while (x + wide < across_ && holdsTile(x + wide, y)) ++wide;
            rects.push_back(rectOf(x, y, wide));
            x += wide;
        }
    return rects;
}

ShapeTiles::ShapeTiles(const View& view, int width, int height, int side)
    : toClip_(view.worldToClip().cast<double>()),
      nearest_(0.5 * static_cast<double>(view.nearest)),
      width_(width),
      height_(height),
      side_(side),
      rows_(static_cast<std::size_t>((height + side - 1) / side), Extent{kFar, -kFar}),
      first_(static_cast<int>(rows_.size())),
      last_(-1) {}

/// Cuts the face at the near plane, with its new edge.
void ShapeTiles::addFace(const Vec3* corners, int count, float margin) {
    clip_.clear();
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector4d a = toClip_ * corners[i].cast<double>().homogeneous();
        const Eigen::Vector4d b =
            toClip_ * corners[(i + 1) % count].cast<double>().homogeneous();
        if (a.w() >= nearest_) clip_.push_back(a);
        if ((a.w() >= nearest_) != (b.w() >= nearest_))
            clip_.push_back(a + (nearest_ - a.w()) / (b.w() - a.w()) * (b - a));
    }
    const auto pixel = [this](const Eigen::Vector4d& p) -> Eigen::Vector2d {
        const double w = std::max(p.w(), nearest_);
        return {(0.5 * p.x() / w + 0.5) * width_, (0.5 - 0.5 * p.y() / w) * height_};
    };
    for (std::size_t i = 0; i < clip_.size(); ++i)
        addEdge(pixel(clip_[i]), pixel(clip_[(i + 1) % clip_.size()]), static_cast<double>(margin));
}

void ShapeTiles::addBox(const Vec3& middle, const Vec3& u, const Vec3& v, const Vec3& w) {
    const Vec3* axes[3] = {&u, &v, &w};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const Vec3 at = middle + side * *axes[axis];
            const Vec3 &a = *axes[(axis + 1) % 3], &b = *axes[(axis + 2) % 3];
            const Vec3 corners[4] = {at - a - b, at + a - b, at + a + b, at - a + b};
            addFace(corners, 4, kMargin);
        }
}

/// In every row that the edge comes near to: its ends, or where it is cut by the row's borders.
void ShapeTiles::addEdge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double margin) {
    const double top = std::min(a.y(), b.y()) - margin, bottom = std::max(a.y(), b.y()) + margin;
    if (!(bottom >= 0.0) || !(top <= height_)) return;
    const double most = static_cast<double>(rows_.size()) - 1.0, rise = b.y() - a.y();
    const int first = static_cast<int>(std::clamp(std::floor(top / side_), 0.0, most));
    const int last = static_cast<int>(std::clamp(std::floor(bottom / side_), 0.0, most));
    for (int row = first; row <= last; ++row) {
        const double low = row * side_ - margin, high = low + side_ + 2.0 * margin;
        double from = 0.0, to = 1.0;
        if (std::abs(rise) > 1e-9) {
            const double atLow = (low - a.y()) / rise, atHigh = (high - a.y()) / rise;
            from = std::clamp(std::min(atLow, atHigh), 0.0, 1.0);
            to = std::clamp(std::max(atLow, atHigh), 0.0, 1.0);
        }
        const double x0 = a.x() + from * (b.x() - a.x()), x1 = a.x() + to * (b.x() - a.x());
        Extent& extent = rows_[static_cast<std::size_t>(row)];
        extent.low = std::min(extent.low, static_cast<float>(std::min(x0, x1) - margin));
        extent.high = std::max(extent.high, static_cast<float>(std::max(x0, x1) + margin));
    }
    first_ = std::min(first_, first);
    last_ = std::max(last_, last);
}

template <class Visit>
bool ShapeTiles::visitTiles(Visit visit) {
    const float side = static_cast<float>(side_), right = static_cast<float>(width_ - 1);
    bool stopped = false;
    for (int row = first_; row <= last_; ++row) {
        Extent& extent = rows_[static_cast<std::size_t>(row)];
        const float low = std::max(extent.low, 0.0f), high = std::min(extent.high, right);
        if (low <= high)
            for (int x = static_cast<int>(low / side);
                 !stopped && static_cast<float>(x) * side <= high; ++x)
                stopped = visit(x, row);
        extent = {kFar, -kFar};
    }
    first_ = static_cast<int>(rows_.size()), last_ = -1;
    return stopped;
}

void ShapeTiles::moveTo(TileSet& set) {
    visitTiles([&set](int x, int y) {
        set.addTile(x, y);
        return false;
    });
}

bool ShapeTiles::meet(const TileSet& set) {
    return visitTiles([&set](int x, int y) { return set.holdsTile(x, y); });
}

}  // namespace render
