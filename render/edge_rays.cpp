// As in ray_surface.cpp, but the rays may miss. With the ray o + t d in the surface's axes:
// Box:      the last of the three entries  (-sign(d_i) half_i - o_i) / d_i,  if before all exits
// Cylinder: the smaller root of  a t^2 + 2 b t + c = 0  across the core;  sphere: in all axes
// Plane:    t = -o_y / d_y
// Closed:   inside the cylinder or cone and inside the layer between its ends at the same time
// Hull:     the last entry through its planes, if it is before all exits
#include "render/edge_rays.h"

#include "render/mesh_tree.h"
#include "render/surface_map.h"

namespace render {
namespace {

/// Entries behind the eye are not drawn.
Four where(FourInts hit, Four t) {
    hit &= t > 0.0f;
    return hit ? t : fourOf(kNever);
}

/// The smaller root of a t^2 + 2 b t + c; NaN if there is none.
Four firstRoot(Four a, Four b, Four c) { return (-b - squareRoot(b * b - a * c)) / a; }

Four larger(Four a, Four b) { return a > b ? a : b; }

/// The part of each ray that is inside, from `in` to `out`.
struct RaySpan {
    Four in, out;
};

/// Clips a span to the layer between two heights; face 2 or 3 where the ray enters through an end.
FourHits between(float low, float high, float eye, Four dy, RaySpan span) {
    const Four inverse = 1.0f / dy;
    const FourInts upwards = dy > 0.0f;
    const Four atLow = (low - eye) * inverse, atHigh = (high - eye) * inverse;
    const Four enter = upwards ? atLow : atHigh;
    const FourInts byEnd = enter > span.in;
    const Four in = byEnd ? enter : span.in;
    const Four out = smaller(upwards ? atHigh : atLow, span.out);
    const FourInts face = byEnd ? (upwards ? FourInts{} + 2 : FourInts{} + 3) : FourInts{};
    return {where(in <= out, in), face};
}

}  // namespace

struct SeenSurface::Rays {
    Four d[3];
};

SeenSurface::SeenSurface(const Surface& surface, const Sight& sight)
    : kind_(surface.kind), mesh_(surface.mesh), half_(surface.half.cast<float>()) {
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
        case SurfaceKind::cylinder: return enterCylinder(rays);
        case SurfaceKind::cone: return enterCone(rays);
        case SurfaceKind::hull: return enterHull(rays);
        case SurfaceKind::mesh: return enterMesh(rays);
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
        const Four entry = smaller(low, high);  // also if infinite, for a ray along a face
        const FourInts later = entry > in;
        in = later ? entry : in;
        face = later ? (forward ? FourInts{} + 2 * i : FourInts{} + (2 * i + 1)) : face;
        out = smaller(low > high ? low : high, out);
    }
    return {where(in <= out, in), face};
}

/// A ray that enters the infinite cylinder beyond an end can enter the capsule only at that end.
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

FourHits SeenSurface::enterCylinder(const Rays& rays) const {
    const auto& [dx, dy, dz] = rays.d;
    const Four a = larger(dx * dx + dz * dz, fourOf(1e-20f));  // along the axis: always or never
    const Four b = dx * eye_.x() + dz * eye_.z();
    const float c = eye_.x() * eye_.x() + eye_.z() * eye_.z() - half_.x() * half_.x();
    const Four square = b * b - a * c, root = squareRoot(positive(square));
    const FourInts never = square < 0.0f;
    const RaySpan span{never ? fourOf(kNever) : (-b - root) / a,
                       never ? fourOf(-kNever) : (-b + root) / a};
    return between(-half_.y(), half_.y(), eye_.y(), dy, span);
}

/// A steep ray (a < 0) is inside one half of the double cone from a root on, or up to a root.
FourHits SeenSurface::enterCone(const Rays& rays) const {
    const auto& [dx, dy, dz] = rays.d;
    const float k = half_.x() / (2.0f * half_.y()), kk = k * k, y = eye_.y() - 1.5f * half_.y();
    const Four a = dx * dx + dz * dz - kk * dy * dy;
    const Four b = dx * eye_.x() + dz * eye_.z() - kk * y * dy;
    const float c = eye_.x() * eye_.x() + eye_.z() * eye_.z() - kk * y * y;
    const Four square = b * b - a * c, root = squareRoot(positive(square));
    const Four far = b > 0.0f ? -b - root : root - b;  // avoids cancellation
    const Four one = far / a, other = c / far;
    const Four first = smaller(one, other), last = larger(one, other);
    const FourInts steep = a < 0.0f, never = (a > 0.0f) & (square < 0.0f), down = dy < 0.0f;
    RaySpan span{steep ? (down ? last : fourOf(-kNever)) : first,
                 steep ? (down ? fourOf(kNever) : first) : last};
    span.in = never ? fourOf(kNever) : span.in;
    span.out = never ? fourOf(-kNever) : span.out;
    return between(-0.5f * half_.y(), 1.5f * half_.y(), eye_.y(), dy, span);
}

FourHits SeenSurface::enterHull(const Rays& rays) const {
    Four in = fourOf(-kNever), out = fourOf(kNever);
    FourInts face{};
    for (std::size_t i = 0; i < mesh_->planes.size(); ++i) {
        const Vec3& n = mesh_->planes[i].normal;
        const float inside = mesh_->planes[i].offset - n.dot(eye_);
        const Four along = rays.d[0] * n.x() + rays.d[1] * n.y() + rays.d[2] * n.z();
        const Four t = inside / along;
        const FourInts later = (along < 0.0f) & (t > in);
        in = later ? t : in;
        face = later ? FourInts{} + static_cast<int>(i) : face;
        out = along >= 0.0f ? smaller(t, out) : out;
    }
    return {where(in <= out, in), face};
}

FourHits SeenSurface::enterMesh(const Rays& rays) const {
    const FourTriangles met =
        nearestTriangles(*mesh_, {eye_, {rays.d[0], rays.d[1], rays.d[2]}});
    FourInts face{};
    for (int i = 0; i < kFour; ++i)
        if (met.triangle[i] >= 0) face[i] = mesh_->facets[met.triangle[i]] & (kFaces - 1);
    return {met.t, face};
}

}  // namespace render
