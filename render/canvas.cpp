#include "render/canvas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/blend.h"

namespace render {
namespace {

using Vec2d = Eigen::Vector2d;

constexpr int kBandRows = 64;  // of coverage at a time, so that a tall line needs little memory

bool isFinite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Pixels first..last of a row or column.
struct PixelSpan {
    int first = 0, last = -1;
};

/// Those of `within` whose centres lie in [low, high].
PixelSpan spanOf(double low, double high, PixelSpan within) {
    const double first = within.first, end = within.last + 1.0;
    return {static_cast<int>(std::ceil(std::clamp(low - 0.5, first, end))),
            static_cast<int>(std::floor(std::clamp(high - 0.5, first - 1.0, end - 1.0)))};
}

/// The part of the unit interval around x that lies in [low, high].
double overlap(double x, double low, double high) {
    return std::clamp(std::min(x + 0.5, high) - std::max(x - 0.5, low), 0.0, 1.0);
}

/// A part of a picture; for each pixel the share of it that a line covers.
struct Band {
    PixelSpan columns, rows;  // of the picture
    std::vector<float> cover;

    int width() const { return columns.last - columns.first + 1; }
    float& at(int x, int y) {
        return cover[static_cast<std::size_t>(y - rows.first) * width() + x - columns.first];
    }
};

/// A segment of a line, with the line's half width.
struct Segment {
    Vec2d a, b;
    double half;

    double distance(const Vec2d& p) const {
        const Vec2d ab = b - a;
        const double square = ab.squaredNorm();
        const double t = square > 0.0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
        return (p - a - t * ab).norm();
    }
    double reach() const { return half + 0.5; }
    /// The columns that the line may cover in the row at height y.
    PixelSpan columns(double y, PixelSpan within) const {
        double from = 0.0, to = 1.0;
        const double rise = b.y() - a.y();
        if (rise != 0.0) {
            const double t0 = (y - reach() - a.y()) / rise, t1 = (y + reach() - a.y()) / rise;
            from = std::clamp(std::min(t0, t1), 0.0, 1.0);
            to = std::clamp(std::max(t0, t1), 0.0, 1.0);
        }
        const double x0 = a.x() + from * (b.x() - a.x()), x1 = a.x() + to * (b.x() - a.x());
        return spanOf(std::min(x0, x1) - reach(), std::max(x0, x1) + reach(), within);
    }
};

/// Keeps the greatest coverage of all segments, that of the nearest, so joints are not drawn twice.
void cover(Band& band, const Segment& s) {
    const PixelSpan rows = spanOf(std::min(s.a.y(), s.b.y()) - s.reach(),
                                  std::max(s.a.y(), s.b.y()) + s.reach(), band.rows);
    for (int y = rows.first; y <= rows.last; ++y) {
        const PixelSpan columns = s.columns(y + 0.5, band.columns);
        for (int x = columns.first; x <= columns.last; ++x) {
            const double here = overlap(s.distance({x + 0.5, y + 0.5}), -s.half, s.half);
            band.at(x, y) = std::max(band.at(x, y), static_cast<float>(here));
        }
    }
}

void blendBand(Image& image, Band& band, const Color& color) {
    for (int y = band.rows.first; y <= band.rows.last; ++y)
        for (int x = band.columns.first; x <= band.columns.last; ++x)
            blend(image.at(x, y), color, band.at(x, y));
}

std::vector<Segment> segmentsOf(std::span<const Point> points, double half) {
    std::vector<Segment> segments;
    const auto vec = [](Point p) { return Vec2d(p.x, p.y); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) continue;
        const bool goesOn = i + 1 < points.size() && isFinite(points[i + 1]);
        const bool cameFrom = i > 0 && isFinite(points[i - 1]);
        if (goesOn)
            segments.push_back({vec(points[i]), vec(points[i + 1]), half});
        else if (!cameFrom)  // a single point is a dot
            segments.push_back({vec(points[i]), vec(points[i]), half});
    }
    return segments;
}

/// The bounds of all segments, clipped to the picture.
void boundsOf(const std::vector<Segment>& segments, const Image& image, PixelSpan& columns,
              PixelSpan& rows) {
    Vec2d low(1e300, 1e300), high(-1e300, -1e300);
    for (const Segment& s : segments) {
        low = low.cwiseMin(s.a.cwiseMin(s.b));
        high = high.cwiseMax(s.a.cwiseMax(s.b));
    }
    const double reach = segments.front().reach();
    columns = spanOf(low.x() - reach, high.x() + reach, {0, image.width - 1});
    rows = spanOf(low.y() - reach, high.y() + reach, {0, image.height - 1});
}

}  // namespace

void fillRectangle(Image& image, Point corner, float width, float height, const Color& color) {
    if (!isFinite(corner) || !isFinite({width, height})) return;
    const double x0 = static_cast<double>(corner.x), x1 = x0 + static_cast<double>(width);
    const double y0 = static_cast<double>(corner.y), y1 = y0 + static_cast<double>(height);
    const PixelSpan columns = spanOf(x0 - 0.5, x1 + 0.5, {0, image.width - 1});
    const PixelSpan rows = spanOf(y0 - 0.5, y1 + 0.5, {0, image.height - 1});
    for (int y = rows.first; y <= rows.last; ++y)
        for (int x = columns.first; x <= columns.last; ++x)
            blend(image.at(x, y), color,
                  static_cast<float>(overlap(x + 0.5, x0, x1) * overlap(y + 0.5, y0, y1)));
}

void drawPolyline(Image& image, std::span<const Point> points, float width, const Color& color) {
    if (!(width > 0.0f) || !std::isfinite(width)) return;
    const std::vector<Segment> segments = segmentsOf(points, 0.5 * static_cast<double>(width));
    if (segments.empty()) return;
    Band band;
    PixelSpan rows;
    boundsOf(segments, image, band.columns, rows);
    for (int top = rows.first; top <= rows.last; top += kBandRows) {
        band.rows = {top, std::min(top + kBandRows - 1, rows.last)};
        band.cover.assign(static_cast<std::size_t>(band.width()) * kBandRows, 0.0f);
        for (const Segment& segment : segments) cover(band, segment);
        blendBand(image, band, color);
    }
}

}  // namespace render
