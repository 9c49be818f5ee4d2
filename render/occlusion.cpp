#include "render/occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/four.h"

namespace render {
namespace {

constexpr int kCell = 4;  // the pattern repeats every 4 x 4 pixels
constexpr float kTurns = 3.0f;
constexpr float kWidest = 0.12f;  // of the height: the largest distance of a sample
static_assert(kCell == kFour, "four pixels in a row are a row of a cell");

/// The positions of a pixel's samples: a spiral of radius 1, whose start depends on the pixel's
/// place in its cell. Stored for four pixels in a row, by sample and row of the cell.
class Pattern {
public:
    Pattern(int samples, float turn) : samples_(samples) {
        for (int cy = 0; cy < kCell; ++cy)
            for (int sample = 0; sample < samples; ++sample) {
                x_.emplace_back(), y_.emplace_back();
                for (int cx = 0; cx < kCell; ++cx) {
                    const int order = (cx * 4 + cy * 7 + (cx ^ cy) * 3) & 15;
                    const float start = static_cast<float>(order) / 16.0f + turn;
                    const float t =
                        (static_cast<float>(sample) + 0.5f) / static_cast<float>(samples);
                    const float angle = (t * kTurns + start) * 6.2831853f;
                    x_.back()[cx] = std::cos(angle) * t;
                    y_.back()[cx] = std::sin(angle) * t;
                }
            }
    }
    int samples() const { return samples_; }
    const Four& x(int row, int sample) const { return x_[row % kCell * samples_ + sample]; }
    const Four& y(int row, int sample) const { return y_[row % kCell * samples_ + sample]; }

private:
    int samples_;
    std::vector<Four> x_, y_;
};

/// Four points.
struct Points {
    Four x, y, z;
};
Points operator-(const Points& a, const Points& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Four dot(const Points& a, const Points& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Points cross(const Points& a, const Points& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The shorter of the two steps: the other one may leave the surface.
Points slope(const Points& before, const Points& here, const Points& after) {
    const Points a = here - before, b = after - here;
    const FourInts first = magnitude(a.z) < magnitude(b.z);
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/// The computation of one map, four pixels at a time.
class Occlusion {
public:
    Occlusion(const DepthMap& depth, const OcclusionSettings& settings, int samples, float turn)
        : depth_(depth),
          set_(settings),
          pattern_(samples, turn),
          scaleX_(2.0f * settings.lensX / static_cast<float>(depth.width)),
          scaleY_(2.0f * settings.lensY / static_cast<float>(depth.height)) {}

    /// `x`: a multiple of 4. Values beyond the right edge are meaningless.
    Four open(int x, int y) const;

private:
    Four depths(int x, int y) const;
    Points points(int x, int y) const;
    Points normals(int x, int y, const Points& here) const;
    /// sampleX, sampleY: pixels.
    Four hidden(const Points& here, const Points& normal, Four sampleX, Four sampleY) const;

    const DepthMap& depth_;
    const OcclusionSettings& set_;
    const Pattern pattern_;
    float scaleX_, scaleY_;  // m per pixel at 1 m
};

/// The depths of four pixels from (x, y) to the right; outside the map, of the nearest inside.
Four Occlusion::depths(int x, int y) const {
    const int row = std::clamp(y, 0, depth_.height - 1);
    Four four;
    if (x >= 0 && x + kFour <= depth_.width)
        std::memcpy(&four, &depth_.meters[static_cast<std::size_t>(row) * depth_.width + x],
                    sizeof four);
    else
        for (int i = 0; i < kFour; ++i)
            four[i] = depth_.at(std::clamp(x + i, 0, depth_.width - 1), row);
    return four;
}

Points Occlusion::points(int x, int y) const {
    const Four d = depths(x, y);
    const Four right = static_cast<float>(x) + Four{0.5f, 1.5f, 2.5f, 3.5f};
    const float down = static_cast<float>(y) + 0.5f;
    return {(right * scaleX_ - set_.lensX) * d, (set_.lensY - down * scaleY_) * d, -d};
}

Points Occlusion::normals(int x, int y, const Points& here) const {
    const Points dx = slope(points(x - 1, y), here, points(x + 1, y));
    const Points dy = slope(points(x, y + 1), here, points(x, y - 1));
    const Points n = cross(dx, dy);
    const Four length = squareRoot(dot(n, n));
    return {n.x / length, n.y / length, n.z / length};
}

/// (1 - v^2 / r^2)^2  max(v . n - bias, 0) / (v^2 + epsilon),  v: from here to a sample
Four Occlusion::hidden(const Points& here, const Points& normal, Four sampleX,
                       Four sampleY) const {
    const Four lastX = fourOf(static_cast<float>(depth_.width - 1));
    const Four lastY = fourOf(static_cast<float>(depth_.height - 1));
    const FourInts sx = __builtin_convertvector(smaller(positive(sampleX), lastX), FourInts);
    const FourInts sy = __builtin_convertvector(smaller(positive(sampleY), lastY), FourInts);
    Four depth;
    for (int i = 0; i < kFour; ++i) depth[i] = depth_.at(sx[i], sy[i]);
    const Four x = __builtin_convertvector(sx, Four), y = __builtin_convertvector(sy, Four);
    const Points v = Points{((x + 0.5f) * scaleX_ - set_.lensX) * depth,
                            (set_.lensY - (y + 0.5f) * scaleY_) * depth, -depth} -
                     here;
    const Four square = dot(v, v);
    const Four fall = positive(1.0f - square * (1.0f / (set_.reach * set_.reach)));
    const Four rise = positive(dot(v, normal) + 0.004f * here.z);
    return fall * fall * rise / (square + 0.004f);
}

Four Occlusion::open(int x, int y) const {
    const Points here = points(x, y);
    const Four away = -here.z;
    const Four share = smaller(0.5f * set_.reach / (away * set_.lensY), fourOf(kWidest));
    const Four pixels = share * static_cast<float>(depth_.height);
    const FourInts far = (away > 0.6f * set_.farthest) | (pixels < 1.0f);
    if (far[0] & far[1] & far[2] & far[3]) return fourOf(1.0f);
    const Points n = normals(x, y, here);
    const Four middleX = static_cast<float>(x) + Four{0.5f, 1.5f, 2.5f, 3.5f};
    const float middleY = static_cast<float>(y) + 0.5f;
    Four sum{};
    for (int sample = 0; sample < pattern_.samples(); ++sample)
        sum += hidden(here, n, pattern_.x(y, sample) * pixels + middleX,
                      pattern_.y(y, sample) * pixels + middleY);
    const float strength = 1.9f * set_.reach / static_cast<float>(pattern_.samples());
    return far ? fourOf(1.0f) : positive(1.0f - sum * strength);
}

/// Calls put(x, y, open) for every pixel of a tile that is within the bounds.
template <class Put>
void forTile(const PixelRect& tile, const PixelRect& bounds, const Occlusion& occlusion, Put put) {
    const int right = std::min(tile.x1, bounds.x1);
    for (int y = std::max(tile.y0, bounds.y0); y < std::min(tile.y1, bounds.y1); ++y)
        for (int x = std::max(tile.x0, bounds.x0 / kFour * kFour); x < right; x += kFour) {
            const Four open = occlusion.open(x, y);
            for (int i = std::max(bounds.x0 - x, 0); i < std::min(kFour, right - x); ++i)
                put(x + i, y, open[i]);
        }
}

/// 0..1 to a byte, in 51 steps: finer steps are not visible and make files larger.
std::uint8_t byteInSteps(float open) {
    return static_cast<std::uint8_t>(5 * static_cast<int>(51.0f * open + 0.5f));
}

/// One row of the mean over the pattern's 4 x 4 cells, without pixels at another depth.
class BlurredRow {
public:
    BlurredRow(const DepthMap& depth, const std::vector<float>& open, const PixelRect& where)
        : depth_(depth), open_(open), where_(where), sum_(depth.width), weight_(depth.width) {}

    /// From column x0 to x1, which are within the region.
    void find(int y, int x0, int x1, std::uint8_t* out) {
        std::fill(sum_.begin() + x0, sum_.begin() + x1, 0.0f);
        std::fill(weight_.begin() + x0, weight_.begin() + x1, 0.0f);
        const int first = std::max(y - kCell / 2, where_.y0);
        const int last = std::min(y + kCell / 2, where_.y1);
        for (int j = first; j < last; ++j)
            for (int shift = -kCell / 2; shift < kCell / 2; ++shift) add(y, j, shift, x0, x1);
        for (int x = x0; x < x1; ++x)  // the pixel itself is always one of them
            out[x] = byteInSteps(sum_[x] / weight_[x]);
    }

private:
    void add(int y, int other, int shift, int x0, int x1) {
        const float* here = &depth_.meters[static_cast<std::size_t>(y) * depth_.width];
        const std::size_t at = static_cast<std::size_t>(other) * depth_.width;
        const float *there = &depth_.meters[at], *open = &open_[at];
        const int first = std::max(x0, where_.x0 - shift);
        const int last = std::min(x1, where_.x1 - shift);
        for (int x = first; x < last; ++x) {
            const float apart = std::abs(there[x + shift] - here[x]);
            const float w = apart < 0.012f * here[x] ? 1.0f : 0.0f;
            sum_[x] += w * open[x + shift];
            weight_[x] += w;
        }
    }

    const DepthMap& depth_;
    const std::vector<float>& open_;
    const PixelRect& where_;
    std::vector<float> sum_, weight_;
};

}  // namespace

int occlusionRadius(const OcclusionSettings& settings, float nearest, int height) {
    const float share = 0.5f * settings.reach / (std::max(nearest, 1e-3f) * settings.lensY);
    const float pixels = std::min(share, kWidest) * static_cast<float>(height);
    return static_cast<int>(std::ceil(pixels)) + kCell;
}

ByteMap openness(const DepthMap& depth, const OcclusionSettings& settings) {
    KeptOpenness one;
    one.renew(depth, settings, nullptr);
    return one.map();
}

ByteMap roughOpenness(const DepthMap& depth, const OcclusionSettings& settings, float turn) {
    ByteMap map{depth.width, depth.height, std::vector<std::uint8_t>(depth.meters.size(), 255)};
    const Occlusion occlusion(depth, settings, 4, turn);
    const PixelRect bounds = boundsOf(settings.where);
    TileSet held(depth.width, depth.height, KeptOpenness::kSide);
    for (const PixelRect& rect : settings.where) held.add(rect);
    for (const PixelRect& tiles : held.rects())
        forTile(tiles, bounds, occlusion, [&map](int x, int y, float open) {
            map.row(y)[x] = static_cast<std::uint8_t>(255.0f * open + 0.5f);
        });
    return map;
}

namespace {

/// With the `radius` pixels around each.
TileSet grown(const TileSet& tiles, int radius, int width, int height) {
    TileSet result(width, height, tiles.side());
    for (const PixelRect& rect : tiles.rects()) result.add(rect.grown(radius, width, height));
    return result;
}

}  // namespace

/// A value depends on the depths around it, on whether it is computed at all, and, near the border,
/// on whether its neighbours are.
TileSet KeptOpenness::tilesToRenew(const PixelRect& bounds, const TileSet& held,
                                   const TileSet& changed, int radius) const {
    TileSet tiles = grown(changed, radius, map_.width, map_.height);
    for (int y = 0; y < held.down(); ++y)
        for (int x = 0; x < held.across(); ++x)
            if (held.holdsTile(x, y) != held_.holdsTile(x, y)) tiles.addTile(x, y);
    const auto addBorder = [&](int before, int now, bool vertical) {
        if (before == now) return;
        for (const int at : {before, now})
            tiles.add(vertical ? PixelRect{at - kCell, 0, at + kCell, map_.height}
                               : PixelRect{0, at - kCell, map_.width, at + kCell});
    };
    addBorder(bounds_.x0, bounds.x0, true);
    addBorder(bounds_.x1, bounds.x1, true);
    addBorder(bounds_.y0, bounds.y0, false);
    addBorder(bounds_.y1, bounds.y1, false);
    return tiles;
}

TileSet KeptOpenness::renew(const DepthMap& depth, const OcclusionSettings& settings,
                            const TileSet* changed) {
    const PixelRect bounds = boundsOf(settings.where);
    TileSet held(depth.width, depth.height, kSide), tiles = held, different = held;
    for (const PixelRect& rect : settings.where) held.add(rect);
    if (changed) {
        tiles = tilesToRenew(bounds, held, *changed, settings.radius);
    } else {
        map_ = {depth.width, depth.height, std::vector<std::uint8_t>(depth.meters.size(), 255)};
        open_.assign(depth.meters.size(), 1.0f);
        tiles = held;
        different.addAll();
    }
    const Occlusion occlusion(depth, settings, 8, 0.0f);
    for (const PixelRect& rect : tiles.rects()) {
        for (int y = rect.y0; y < rect.y1 && changed; ++y)
            std::fill_n(&open_[static_cast<std::size_t>(y) * depth.width + rect.x0],
                        rect.x1 - rect.x0, 1.0f);
        for (int x = rect.x0; x < rect.x1; x += kSide)
            if (held.hold(x, rect.y0))
                forTile({x, rect.y0, std::min(x + kSide, rect.x1), rect.y1}, bounds, occlusion,
                        [&](int px, int py, float open) {
                            open_[static_cast<std::size_t>(py) * depth.width + px] = open;
                        });
    }
    held_ = std::move(held), bounds_ = bounds;
    const TileSet blurred = grown(tiles, kCell, depth.width, depth.height);
    BlurredRow row(depth, open_, bounds);
    std::vector<std::uint8_t> line(static_cast<std::size_t>(depth.width));
    for (const PixelRect& rect : blurred.rects())
        for (int y = rect.y0; y < rect.y1; ++y) {
            std::fill(line.begin() + rect.x0, line.begin() + rect.x1, 255);
            const int x0 = std::max(rect.x0, bounds.x0), x1 = std::min(rect.x1, bounds.x1);
            if (y >= bounds.y0 && y < bounds.y1 && x0 < x1) row.find(y, x0, x1, line.data());
            for (int x = rect.x0; x < rect.x1; x += kSide) {
                const int count = std::min(kSide, rect.x1 - x);
                if (std::equal(&line[x], &line[x] + count, map_.row(y) + x)) continue;
                std::copy_n(&line[x], count, map_.row(y) + x);
                different.add(PixelRect{x, y, x + count, y + 1});
            }
        }
    return different;
}

namespace {

/// A row of a doubled map: two pixels for each value of `column`, which has one more on each side.
void doubleRow(const std::uint16_t* column, int count, std::uint8_t* out) {
    for (int k = 0; k < count; ++k) {
        const int near = 3 * column[k + 1] + 8;
        out[2 * k] = static_cast<std::uint8_t>((near + column[k]) >> 4);
        out[2 * k + 1] = static_cast<std::uint8_t>((near + column[k + 2]) >> 4);
    }
}

}  // namespace

ByteMap doubled(const ByteMap& map, const PixelRect& where) {
    ByteMap large{where.x1 - where.x0, where.y1 - where.y0, {}};
    large.bytes.resize(static_cast<std::size_t>(large.width) * large.height);
    const int first = where.x0 / 2, count = (where.x1 + 1) / 2 - first;
    const int lastX = map.width - 1, lastY = map.height - 1;
    std::vector<std::uint16_t> column(static_cast<std::size_t>(count) + 2);
    std::vector<std::uint8_t> row(2 * static_cast<std::size_t>(count));
    for (int y = where.y0; y < where.y1; ++y) {
        const std::uint8_t* a = map.row(std::min(y / 2, lastY));
        const std::uint8_t* b = map.row(std::clamp(y / 2 + (y % 2 ? 1 : -1), 0, lastY));
        for (int k = 0; k < count + 2; ++k) {
            const int x = std::clamp(first + k - 1, 0, lastX);
            column[k] = static_cast<std::uint16_t>(3 * a[x] + b[x]);
        }
        doubleRow(column.data(), count, row.data());
        std::copy_n(row.begin() + (where.x0 - 2 * first), large.width, large.row(y - where.y0));
    }
    return large;
}

}  // namespace render
