#include "render/occlusion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr int kCell = 4;  // the pattern repeats every 4 x 4 pixels
constexpr float kTurns = 3.0f;
constexpr float kWidest = 0.12f;  // of the height: a sample is never farther away
using Vec3 = Eigen::Vector3f;

// Four side by side, which every x86-64 processor has; wider ones are taken apart into single ones.
constexpr int kLanes = 4;
using Samples = float __attribute__((vector_size(16)));
using Places = int __attribute__((vector_size(16)));

/// Where the samples of a pixel lie, four to a group: a spiral of a radius of 1, started by the
/// pixel's place in its cell.
class Pattern {
public:
    Pattern(int groups, float turn) : groups_(groups) {
        const int samples = groups * kLanes;
        for (int i = 0; i < kCell * kCell * samples; ++i) {
            const int cell = i / samples, sample = i % samples;
            const int cx = cell % kCell, cy = cell / kCell;
            const int order = (cx * 4 + cy * 7 + (cx ^ cy) * 3) & 15;
            const float start = static_cast<float>(order) / 16.0f + turn;
            const float t = (static_cast<float>(sample) + 0.5f) / static_cast<float>(samples);
            const float angle = (t * kTurns + start) * 6.2831853f;
            if (i % kLanes == 0) x_.emplace_back(), y_.emplace_back();
            x_.back()[i % kLanes] = std::cos(angle) * t;
            y_.back()[i % kLanes] = std::sin(angle) * t;
        }
    }
    int groups() const { return groups_; }
    const Samples& x(int cell, int group) const { return x_[cell * groups_ + group]; }
    const Samples& y(int cell, int group) const { return y_[cell * groups_ + group]; }

private:
    int groups_;
    std::vector<Samples> x_, y_;
};

Samples positive(Samples v) { return v > 0.0f ? v : Samples{}; }

Places within(Places v, int most) {
    v = v > 0 ? v : Places{};
    return v < most ? v : Places{} + most;
}

/// The whole computation of one map.
class Occlusion {
public:
    Occlusion(const DepthMap& depth, const OcclusionSettings& settings, int groups, float turn)
        : depth_(depth),
          set_(settings),
          pattern_(groups, turn),
          scaleX_(2.0f * settings.lensX / static_cast<float>(depth.width)),
          scaleY_(2.0f * settings.lensY / static_cast<float>(depth.height)) {}

    float open(int x, int y) const;

private:
    Vec3 point(int x, int y) const {
        const float d = depth_.at(x, y);
        return {((static_cast<float>(x) + 0.5f) * scaleX_ - set_.lensX) * d,
                (set_.lensY - (static_cast<float>(y) + 0.5f) * scaleY_) * d, -d};
    }
    Vec3 normal(int x, int y, const Vec3& here) const;
    /// fx, fy: pixels.
    float hidden(const Vec3& here, const Vec3& normal, Samples fx, Samples fy) const;

    const DepthMap& depth_;
    const OcclusionSettings& set_;
    const Pattern pattern_;
    float scaleX_, scaleY_;  // m a pixel at 1 m
};

/// The shorter of the two steps: the other one may lead off the surface.
Vec3 slope(const Vec3& before, const Vec3& here, const Vec3& after) {
    const Vec3 a = here - before, b = after - here;
    return std::abs(a.z()) < std::abs(b.z()) ? a : b;
}

Vec3 Occlusion::normal(int x, int y, const Vec3& here) const {
    const int right = std::min(x + 1, depth_.width - 1), low = std::min(y + 1, depth_.height - 1);
    const Vec3 dx = slope(point(std::max(x - 1, 0), y), here, point(right, y));
    const Vec3 dy = slope(point(x, low), here, point(x, std::max(y - 1, 0)));
    return dx.cross(dy).normalized();
}

/// sum of  (1 - v^2 / r^2)^2  max(v . n - bias, 0) / (v^2 + epsilon),  v: from here to a sample
float Occlusion::hidden(const Vec3& here, const Vec3& normal, Samples fx, Samples fy) const {
    const Places sx = within(__builtin_convertvector(fx, Places), depth_.width - 1);
    const Places sy = within(__builtin_convertvector(fy, Places), depth_.height - 1);
    Samples depth;
    for (int i = 0; i < kLanes; ++i) depth[i] = depth_.at(sx[i], sy[i]);
    const Samples x = __builtin_convertvector(sx, Samples);
    const Samples y = __builtin_convertvector(sy, Samples);
    const Samples vx = ((x + 0.5f) * scaleX_ - set_.lensX) * depth - here.x();
    const Samples vy = (set_.lensY - (y + 0.5f) * scaleY_) * depth - here.y();
    const Samples vz = -depth - here.z();
    const Samples square = vx * vx + vy * vy + vz * vz;
    const Samples fall = positive(1.0f - square * (1.0f / (set_.reach * set_.reach)));
    const Samples rise =
        positive(vx * normal.x() + vy * normal.y() + vz * normal.z() + 0.004f * here.z());
    const Samples part = fall * fall * rise / (square + 0.004f);
    return (part[0] + part[1]) + (part[2] + part[3]);
}

float Occlusion::open(int x, int y) const {
    const Vec3 here = point(x, y);
    const float away = -here.z();
    const float share = std::min(0.5f * set_.reach / (away * set_.lensY), kWidest);
    const float pixels = share * static_cast<float>(depth_.height);
    if (away > 0.6f * set_.farthest || pixels < 1.0f) return 1.0f;
    const Vec3 n = normal(x, y, here);
    const float middleX = static_cast<float>(x) + 0.5f, middleY = static_cast<float>(y) + 0.5f;
    const int cell = y % kCell * kCell + x % kCell;
    float sum = 0.0f;
    for (int group = 0; group < pattern_.groups(); ++group)
        sum += hidden(here, n, pattern_.x(cell, group) * pixels + middleX,
                      pattern_.y(cell, group) * pixels + middleY);
    const auto samples = static_cast<float>(pattern_.groups() * kLanes);
    return std::max(0.0f, 1.0f - sum * 1.9f * set_.reach / samples);
}

/// 0..1 to a byte, in 51 steps: finer ones are not seen, and make files larger.
std::uint8_t inSteps(float open) {
    return static_cast<std::uint8_t>(5 * static_cast<int>(51.0f * open + 0.5f));
}

/// The mean over the pattern's 4 x 4 cells, leaving out what lies at another depth: a row of it.
class BlurredRow {
public:
    BlurredRow(const DepthMap& depth, const std::vector<float>& open, const PixelRect& where)
        : depth_(depth), open_(open), where_(where), sum_(depth.width), weight_(depth.width) {}

    void find(int y, std::uint8_t* out) {
        std::fill(sum_.begin(), sum_.end(), 0.0f);
        std::fill(weight_.begin(), weight_.end(), 0.0f);
        const int first = std::max(y - kCell / 2, where_.y0);
        const int last = std::min(y + kCell / 2, where_.y1);
        for (int j = first; j < last; ++j)
            for (int shift = -kCell / 2; shift < kCell / 2; ++shift) add(y, j, shift);
        for (int x = where_.x0; x < where_.x1; ++x)  // the pixel itself is always one of them
            out[x] = inSteps(sum_[x] / weight_[x]);
    }

private:
    void add(int y, int other, int shift) {
        const float* here = &depth_.meters[static_cast<std::size_t>(y) * depth_.width];
        const std::size_t at = static_cast<std::size_t>(other) * depth_.width;
        const float *there = &depth_.meters[at], *open = &open_[at];
        const int first = std::max(where_.x0, where_.x0 - shift);
        const int last = std::min(where_.x1, where_.x1 - shift);
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
    const PixelRect& where = settings.where;
    const Occlusion occlusion(depth, settings, 2, 0.0f);
    ByteMap map{depth.width, depth.height, std::vector<std::uint8_t>(depth.meters.size(), 255)};
    std::vector<float> open(depth.meters.size());
    for (int y = where.y0; y < where.y1; ++y)
        for (int x = where.x0; x < where.x1; ++x)
            open[static_cast<std::size_t>(y) * depth.width + x] = occlusion.open(x, y);
    BlurredRow row(depth, open, where);
    for (int y = where.y0; y < where.y1; ++y) row.find(y, map.row(y));
    return map;
}

ByteMap roughOpenness(const DepthMap& depth, const OcclusionSettings& settings, float turn) {
    const PixelRect& where = settings.where;
    const Occlusion occlusion(depth, settings, 1, turn);
    ByteMap map{depth.width, depth.height, std::vector<std::uint8_t>(depth.meters.size(), 255)};
    for (int y = where.y0; y < where.y1; ++y)
        for (int x = where.x0; x < where.x1; ++x)
            map.row(y)[x] = static_cast<std::uint8_t>(255.0f * occlusion.open(x, y) + 0.5f);
    return map;
}

ByteMap doubled(const ByteMap& map, int width, int height) {
    ByteMap large{width, height, {}};
    large.bytes.resize(static_cast<std::size_t>(width) * height);
    const auto next = [](int i) { return i / 2 + (i % 2 ? 1 : -1); };
    const int lastX = map.width - 1, lastY = map.height - 1;
    std::vector<int> column(static_cast<std::size_t>(map.width));
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* a = map.row(std::min(y / 2, lastY));
        const std::uint8_t* b = map.row(std::clamp(next(y), 0, lastY));
        for (int x = 0; x < map.width; ++x) column[x] = 3 * a[x] + b[x];
        std::uint8_t* out = large.row(y);
        for (int x = 0; x < width; ++x) {
            const int near = column[std::min(x / 2, lastX)];
            const int far = column[std::clamp(next(x), 0, lastX)];
            out[x] = static_cast<std::uint8_t>((3 * near + far + 8) / 16);
        }
    }
    return large;
}

}  // namespace render
