// As in ray_surface.cpp, but the rays may miss. With the ray o + t d in the surface's own axes:
// Box:      the last of the three entries  (-sign(d_i) half_i - o_i) / d_i,  if before every exit
// Cylinder: the smaller root of  a t^2 + 2 b t + c = 0  across the core;  sphere: in all axes
// Plane:    t = -o_y / d_y
#include "render/edge_rays.h"

#include <limits>

namespace render {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// Entries behind the eye are not drawn.
Four where(FourInts hit, Four t) {
    hit &= t > 0.0f;
    return hit ? t : fourOf(kNever);
}

/// The smaller root of a t^2 + 2 b t + c; not a number where there is none.
Four firstRoot(Four a, Four b, Four c) { return (-b - squareRoot(b * b - a * c)) / a; }

}  // namespace

struct SeenSurface::Rays {
    Four d[3];
};

SeenSurface::SeenSurface(const Surface& surface, const Sight& sight)
    : kind_(surface.kind), half_(surface.half.cast<float>()) {
    const Mat3d turn = surface.axes.transpose();
    const auto local = [&turn](const Vec3& v) -> Vec3 {
        return (turn * v.cast<double>()).cast<float>();
    };
    eye_ = (turn * (sight.eye.cast<double>() - surface.at)).cast<float>();
    ahead_ = local(sight.ahead), right_ = local(sight.right), down_ = local(sight.down);
}

FourHits SeenSurface::enter(Four x, Four y) const {
    Rays rays;
    for (int i = 0; i < 3; ++i) rays.d[i] = ahead_[i] + x * right_[i] + y * down_[i];
    switch (kind_) {
        case SurfaceKind::box: return enterBox(rays);
        case SurfaceKind::capsule: return enterCapsule(rays);
        case SurfaceKind::bar: return enterBar(rays);
        case SurfaceKind::plane: return enterPlane(rays);
    }
    return {fourOf(kNever), FourInts{}};
}

FourHits SeenSurface::enterBox(const Rays& rays) const {
    Four in = fourOf(-kNever), out = fourOf(kNever);
    FourInts face{};
    for (int i = 0; i < 3; ++i) {
        const Four inverse = 1.0f / rays.d[i];
        const FourInts forward = rays.d[i] > 0.0f;
        const Four low = (-half_[i] - eye_[i]) * inverse, high = (half_[i] - eye_[i]) * inverse;
        const Four entry = smaller(low, high);  // also along a face, where they are infinite
        const FourInts later = entry > in;
        in = later ? entry : in;
        face = later ? (forward ? FourInts{} + 2 * i : FourInts{} + (2 * i + 1)) : face;
        out = smaller(low > high ? low : high, out);
    }
    return {where(in <= out, in), face};
}

/// A ray that comes into the endless cylinder beyond an end can only come into the capsule there.
FourHits SeenSurface::enterCapsule(const Rays& rays) const {
    const auto& [dx, dy, dz] = rays.d;
    const float r = half_.x(), length = half_.y();
    const Four across = dx * dx + dz * dz, b = dx * eye_.x() + dz * eye_.z();
    const float c = eye_.x() * eye_.x() + eye_.z() * eye_.z() - r * r;
    const Four side = firstRoot(across, b, fourOf(c));
    const Four y = eye_.y() + side * dy;
    const FourInts middle = (y <= length) & (y >= -length);
    const Four end = eye_.y() - (y > 0.0f ? fourOf(length) : fourOf(-length));
    const Four round = firstRoot(across + dy * dy, b + end * dy, c + end * end);
    const Four t = middle ? side : round;
    return {where(t == t, t), FourInts{}};
}

/// Open at its ends.
FourHits SeenSurface::enterBar(const Rays& rays) const {
    const auto& [dx, dy, dz] = rays.d;
    const Four b = dx * eye_.x() + dz * eye_.z();
    const float c = eye_.x() * eye_.x() + eye_.z() * eye_.z() - half_.x() * half_.x();
    const Four t = firstRoot(dx * dx + dz * dz, b, fourOf(c));
    const Four y = eye_.y() + t * dy;
    return {where((y <= half_.y()) & (y >= -half_.y()), t), FourInts{}};
}

FourHits SeenSurface::enterPlane(const Rays& rays) const {
    const Four t = -eye_.y() / rays.d[1];
    return {where(t > 0.0f, t), FourInts{}};
}

}  // namespace render
