#include "render/ghost_rays.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

/// Where a ray enters a box or ball.
struct Entry {
    float distance = 0;  // in lengths of the ray's direction
    Vec3 normal;         // in the ghost's axes
};

/// Slabs (Kay and Kajiya 1986).
std::optional<Entry> hitBox(const Vec3& half, const Vec3& from, const Vec3& way) {
    float enter = -1e30f, leave = 1e30f;
    int face = 0;
    for (int i = 0; i < 3; ++i) {
        const float inverse = 1.0f / (std::abs(way[i]) > 1e-12f ? way[i] : 1e-12f);
        const float a = (-half[i] - from[i]) * inverse, b = (half[i] - from[i]) * inverse;
        if (std::min(a, b) > enter) enter = std::min(a, b), face = i;
        leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave || enter < 0.0f) return std::nullopt;
    return Entry{enter, way[face] > 0.0f ? Vec3(-Vec3::Unit(face)) : Vec3(Vec3::Unit(face))};
}

/// A ball around the core's point nearest to the ray: exact for a sphere, else an approximation.
std::optional<Entry> hitRound(float radius, float core, const Vec3& from, const Vec3& way) {
    const float a = way.squaredNorm(), b = way.y(), d = way.dot(from);
    const float square = a - b * b;  // |way|^2 |y|^2 - (way . y)^2
    const float y = square > 1e-9f ? (a * from.y() - b * d) / square : 0.0f;
    const Vec3 o = from - Vec3(0, std::clamp(y, -core, core), 0);
    const float half = way.dot(o), rest = half * half - a * (o.squaredNorm() - radius * radius);
    if (rest < 0.0f) return std::nullopt;
    const float t = (-half - std::sqrt(rest)) / a;
    if (t < 0.0f) return std::nullopt;
    return Entry{t, (o + t * way).normalized()};
}

}  // namespace

GhostRays::GhostRays(const Solid& ghost, const View& view, const Vec3& sun, int width, int height)
    : ghost_(ghost), sun_(sun), surface_(surfaceOf(ghost)), sight_(sightOf(view, width, height)),
      seen_(surface_, sight_) {
    const Quat back = ghost.rotation.conjugate();
    const Eigen::Matrix3f turn =
        back.toRotationMatrix() * view.view.block<3, 3>(0, 0).transpose();
    const float x = 1.0f / view.projection(0, 0), y = 1.0f / view.projection(1, 1);
    from_ = back * Vec3(view.eye - ghost.position);
    corner_ = turn * Vec3(-x, y, -1.0f);
    right_ = turn.col(0) * (2.0f * x / static_cast<float>(width));
    down_ = turn.col(1) * (-2.0f * y / static_cast<float>(height));
    sunInGhost_ = back * sun;
}

std::optional<GhostHit> GhostRays::at(const Vec2& pixel) const {
    const bool capsule = ghost_.shape == SolidShape::capsule;
    std::optional<Entry> entry;
    if (ghost_.shape == SolidShape::box)
        entry = hitBox(ghost_.halfSize, from_, through(pixel));
    else if (capsule || ghost_.shape == SolidShape::sphere)
        entry = hitRound(ghost_.halfSize.x(), capsule ? ghost_.halfSize.y() : 0.0f, from_,
                         through(pixel));
    else
        return onSurface(pixel);
    if (!entry) return std::nullopt;
    return GhostHit{entry->distance, entry->normal.dot(sunInGhost_)};
}

std::optional<GhostHit> GhostRays::onSurface(const Vec2& pixel) const {
    const FourHits hits = seen_.enter(fourOf(pixel.x()), fourOf(pixel.y()));
    if (std::isinf(hits.t[0])) return std::nullopt;
    const Vec3 way = sight_.ahead + pixel.x() * sight_.right + pixel.y() * sight_.down;
    const Hit hit =
        enter(surface_, hits.face[0], {sight_.eye.cast<double>(), way.cast<double>()});
    return GhostHit{hits.t[0], hit.normal.cast<float>().dot(sun_)};
}

}  // namespace render
