// seen     = 1/n sum over the n rays that meet the ghost of  [t_ghost <= t of all around the pixel]
// mirrored = F + (1 - F) (1 - cos)^5, Schlick 1994
#include "render/ghost_rays.h"

#include <algorithm>

#include "render/mesh_tree.h"
#include "render/sampling.h"

namespace render {
namespace {

// Of the distance: a ghost is seen on its own body in the same place.
constexpr float kTie = 0.9999f;
constexpr int kHidden = -2, kMissed = -1;  // instead of a face
constexpr float kStraight = 0.04f;  // F: what glass reflects of light from straight ahead

std::vector<Vec3> normalsOf(const Surface& surface) {
    std::vector<Vec3> normals;
    const Eigen::Matrix3f axes = surface.axes.cast<float>();
    if (surface.kind == SurfaceKind::box)
        for (int i = 0; i < 3; ++i) normals.push_back(-axes.col(i)), normals.push_back(axes.col(i));
    if (surface.kind == SurfaceKind::hull)
        for (const auto& plane : surface.mesh->planes) normals.push_back(axes * plane.normal);
    return normals;
}

/// m from the eye along the view axis.
float alongView(const Sight& sight, const Vec3& point) {
    return (point - sight.eye).dot(sight.right.cross(sight.down).normalized());
}

}  // namespace

GhostRays::GhostRays(const Solid& ghost, const Vec3& sun, const Hiding& hiding,
                     const PixelRange& range)
    : hiding_(hiding),
      sun_(sun),
      hollow_(ghost.mesh && !ghost.mesh->convex),
      middle_(alongView(hiding.seen.sight(), ghost.position)),
      surface_(surfaceOf(ghost)),
      seen_(surface_, hiding.seen.sight()),
      normals_(normalsOf(surface_)),
      range_(range),
      stride_(range.x1 - range.x0 + 1),
      centres_(static_cast<std::size_t>(stride_) * (range.y1 - range.y0 + 1)) {
    const std::vector<SampleOffset> offsets = sampleOffsets(kRays);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        x_[i / kFour][i % kFour] = 0.5f + offsets[i].x;
        y_[i / kFour][i % kFour] = 0.5f + offsets[i].y;
    }
    castCentres();
}

GhostRays::Met GhostRays::meet(Four x, Four y, Four before) const {
    const FourHits hits = seen_.enter(x, y);
    const Four none = fourOf(kNever);
    const FourInts missed = hits.t == none;
    const Four t = missed ? (hollow_ ? none : fourOf(middle_)) : hits.t;
    const FourInts first = (kTie * t <= before) & (t < none);
    return {~missed, first, hits.face};
}

/// Where rays through the middles of four pixels in a row meet the surfaces seen there.
Four GhostRays::beforeFour(int x, int y, Four px, Four py) const {
    Four t = fourOf(kNever);
    if (hiding_.map.packed.empty()) return t;
    int last = kNoSurface;
    for (int i = 0; i < kFour && x + i <= range_.x1; ++i) {
        const int surface = hiding_.map.surface(x + i, y);
        if (surface == kNoSurface || surface == last) continue;
        const Four hits = hiding_.seen[last = surface].enter(px, py).t;
        for (int j = i; j < kFour && x + j <= range_.x1; ++j)
            if (hiding_.map.surface(x + j, y) == surface) t[j] = hits[j];
    }
    return t;
}

void GhostRays::castCentres() {
    const Four steps{0.5f, 1.5f, 2.5f, 3.5f};
    std::size_t at = 0;
    for (int y = range_.y0; y <= range_.y1; ++y)
        for (int x = range_.x0; x <= range_.x1; x += kFour) {
            const Four px = steps + static_cast<float>(x);
            const Four py = fourOf(static_cast<float>(y) + 0.5f);
            const Met met = meet(px, py, beforeFour(x, y, px, py));
            for (int i = 0; i < kFour && x + i <= range_.x1; ++i)
                centres_[at++] = !met.first[i] ? kHidden : met.hit[i] ? met.face[i] : kMissed;
        }
}

void GhostRays::lookAround(int x, int y) {
    count_ = 0;
    const SurfaceMap& map = hiding_.map;
    if (map.packed.empty()) return;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, map.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, map.width - 1); ++column) {
            const int surface = map.surface(column, row);
            const auto end = around_.begin() + static_cast<std::ptrdiff_t>(count_);
            if (surface >= 0 && std::find(around_.begin(), end, surface) == end)
                around_[count_++] = surface;
        }
}

Four GhostRays::nearest(Four x, Four y) {
    Four t = fourOf(kNever);
    for (std::size_t i = 0; i < count_; ++i)
        t = smaller(hiding_.seen[around_[i]].enter(x, y).t, t);
    return t;
}

GhostPixel GhostRays::shade(const Vec2& at, int face) const {
    const Sight& sight = hiding_.seen.sight();
    const Vec3 way = sight.ahead + at.x() * sight.right + at.y() * sight.down;
    const Vec3 normal =
        normals_.empty()
            ? enter(surface_, face, {sight.eye.cast<double>(), way.cast<double>()}).normal.cast<float>()
            : normals_[static_cast<std::size_t>(face)];
    const float across = 1.0f - std::min(std::abs(normal.dot(way)) / way.norm(), 1.0f);
    const float square = across * across, fifth = square * square * across;
    return {1.0f, std::max(normal.dot(sun_), 0.0f), kStraight + (1.0f - kStraight) * fifth};
}

GhostPixel GhostRays::sampled(int x, int y) {
    lookAround(x, y);
    int hits = 0, lit = 0, rim = 0;
    GhostPixel sum;
    for (std::size_t group = 0; group < x_.size(); ++group) {
        const Four px = x_[group] + static_cast<float>(x), py = y_[group] + static_cast<float>(y);
        const Met met = meet(px, py, nearest(px, py));
        for (int i = 0; i < kFour; ++i) {
            hits -= met.hit[i];
            rim -= met.first[i] & ~met.hit[i];
            if (!(met.first[i] & met.hit[i])) continue;
            const GhostPixel one = shade({px[i], py[i]}, met.face[i]);
            sum.facing += one.facing, sum.mirrored += one.mirrored, ++lit;
        }
    }
    if (hits == 0) return {static_cast<float>(rim) / kRays};
    const float each = lit > 0 ? 1.0f / static_cast<float>(lit) : 0.0f;
    const int rays = hollow_ ? kRays : hits;
    return {static_cast<float>(lit) / static_cast<float>(rays), each * sum.facing, each * sum.mirrored};
}

bool GhostRays::sameAround(int x, int y) const {
    const int* row = &centres_[static_cast<std::size_t>(y - range_.y0) * stride_ + (x - range_.x0)];
    return (x == range_.x0 || row[-1] == *row) && (x == range_.x1 || row[1] == *row) &&
           (y == range_.y0 || row[-stride_] == *row) && (y == range_.y1 || row[stride_] == *row);
}

GhostPixel GhostRays::at(int x, int y) {
    if (!sameAround(x, y)) return sampled(x, y);
    const int face = centres_[static_cast<std::size_t>(y - range_.y0) * stride_ + (x - range_.x0)];
    if (face == kHidden) return {};
    return face == kMissed ? GhostPixel{1.0f} : shade(centreOf(x, y), face);
}

}  // namespace render
