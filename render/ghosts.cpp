// Earlier poses, and bodies that only sense, as translucent silhouettes. Rays through every pixel give
// the share of it that nothing hides, and the angle of the ghost's surface to the light.
#include <algorithm>
#include <cmath>
#include <optional>

#include "render/coverage.h"
#include "render/ghost_rays.h"
#include "render/overlay.h"
#include "render/pi.h"
#include "render/solid_mesh.h"

namespace render {
namespace {

constexpr int kRim = 48;  // points around a circle

void addCircle(std::vector<Vec3>& points, const Vec3& middle, const Vec3& u, const Vec3& v,
               float radius) {
    for (int i = 0; i < kRim; ++i) {
        const float angle = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(kRim);
        points.push_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
}

/// For shapes with corners or sharp rims.
std::vector<Vec3> cornerPoints(const Solid& solid) {
    std::vector<Vec3> points;
    const float r = solid.halfSize.x(), h = solid.halfSize.y();
    const Vec3 up = Vec3::UnitY();
    if (solid.shape == SolidShape::mesh && solid.mesh) points = solid.mesh->vertices;
    const auto addRim = [&](float y) {
        addCircle(points, y * up, Vec3::UnitX(), Vec3::UnitZ(), r);
    };
    if (solid.shape == SolidShape::cylinder) addRim(-h), addRim(h);
    if (solid.shape == SolidShape::cone) addRim(-0.5f * h), points.push_back(1.5f * h * up);
    for (Vec3& point : points) point = solid.position + solid.rotation * point;
    return points;
}

/// Points whose convex hull in the picture is the silhouette.
std::vector<Vec3> rimPoints(const Solid& solid, const Vec3& eye) {
    std::vector<Vec3> points;
    if (solid.shape == SolidShape::cylinder || solid.shape == SolidShape::cone ||
        solid.shape == SolidShape::mesh)
        return cornerPoints(solid);
    if (solid.shape == SolidShape::box) {
        for (int i = 0; i < 8; ++i)
            points.push_back(solid.position +
                             solid.rotation * Vec3(solid.halfSize.x() * (i & 1 ? 1.0f : -1.0f),
                                                   solid.halfSize.y() * (i & 2 ? 1.0f : -1.0f),
                                                   solid.halfSize.z() * (i & 4 ? 1.0f : -1.0f)));
        return points;
    }
    const float r = solid.halfSize.x();
    const float core = solid.shape == SolidShape::capsule ? solid.halfSize.y() : 0.0f;
    for (const float end : {-core, core}) {
        // The circle in which a cone from the eye touches the ball.
        const Vec3 centre = solid.position + solid.rotation * Vec3(0, end, 0);
        const Vec3 way = centre - eye;
        const float distance = std::max(way.norm(), 1.001f * r), sine = r / distance;
        const Vec3 middle = centre - way / distance * r * sine;
        const Vec3 u = way.unitOrthogonal(), v = way.normalized().cross(u);
        const float radius = r * std::sqrt(std::max(1.0f - sine * sine, 0.0f));
        addCircle(points, middle, u, v, radius);
        if (core == 0.0f) break;
    }
    return points;
}

float turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The convex hull (Andrew 1979).
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
    const auto before = [](const Vec2& a, const Vec2& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    };
    std::sort(points.begin(), points.end(), before);
    std::vector<Vec2> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0f)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// A silhouette as the half planes of its edges.
class Silhouette {
public:
    explicit Silhouette(const std::vector<Vec2>& hull) {
        low_ = high_ = hull.front();
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
            const Vec2 out = Vec2((b - a).y(), -(b - a).x()).normalized();
            edges_.push_back({out, out.dot(a)});
            low_ = low_.cwiseMin(a), high_ = high_.cwiseMax(a);
        }
    }
    /// Pixels, negative inside; approximate beyond the corners.
    float distance(const Vec2& p) const {
        float most = -1e9f;
        for (const Edge& edge : edges_) most = std::max(most, edge.out.dot(p) - edge.offset);
        return most;
    }
    /// Columns x0 <= x < x1 of a row whose pixels' distance is below `limit`.
    void columns(int y, float limit, int& x0, int& x1) const {
        for (const Edge& edge : edges_) {
            const float rest = limit + edge.offset - edge.out.y() * centreOf(0, y).y();
            const float x = std::clamp(rest / edge.out.x() - 0.5f, -1.0f, 1e6f);
            if (edge.out.x() > 0.0f) x1 = std::min(x1, static_cast<int>(std::ceil(x)));
            if (edge.out.x() < 0.0f) x0 = std::max(x0, static_cast<int>(std::floor(x)) + 1);
            if (edge.out.x() == 0.0f && rest <= 0.0f) x1 = x0;
        }
    }
    const Vec2& low() const { return low_; }
    const Vec2& high() const { return high_; }

private:
    struct Edge {
        Vec2 out;
        float offset;
    };
    std::vector<Edge> edges_;
    Vec2 low_, high_;
};

std::optional<Silhouette> silhouetteOf(const Solid& ghost, const View& view, const Image& image) {
    std::vector<Vec2> flat;
    for (const Vec3& point : rimPoints(ghost, view.eye)) {
        const Projected p = project(view, point, image.width, image.height);
        if (p.depth <= 0) return std::nullopt;  // partly behind the camera
        flat.emplace_back(p.x, p.y);
    }
    const std::vector<Vec2> hull = hullOf(std::move(flat));
    if (hull.size() < 3) return std::nullopt;
    return Silhouette(hull);
}

Color mixed(const Color& a, const Color& b, float share) {
    return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), a.a};
}

/// Darker and denser towards the outline, which is `edge` pixels wide; d: pixels, negative inside.
Color tintOf(const Color& color, const Look& look, const GhostPixel& pixel, float d, float edge) {
    const float rim = std::clamp(d + 0.5f + edge, 0.0f, 1.0f);
    const float light = 0.75f + 0.25f * pixel.facing;
    // The image of the sky, if there is one, lies over the ghost; that of a faint one is faint.
    const float sky = look.transparent ? 0.0f : std::min(3.0f * color.a, 1.0f) * pixel.mirrored;
    const float alpha = sky + (1.0f - sky) * color.a;
    Color tint{color.r * light, color.g * light, color.b * light};
    tint = mixed(tint, look.skyHorizon, sky / std::max(alpha, 1e-6f));
    tint = mixed(tint, look.ink, 0.35f * rim);
    tint.a = std::min(alpha * (1.0f + 1.4f * rim), 1.0f);
    return tint;
}

void drawGhost(Image& image, const Solid& ghost, const Look& look, const View& view,
               const Hiding& hiding) {
    const std::optional<Silhouette> silhouette = silhouetteOf(ghost, view, image);
    if (!silhouette) return;
    const float edge = std::max(0.9f * overlayScale(look, image.width, image.height), 0.7f);
    const PixelRange range =
        pixelsWithin(image, silhouette->low() - Vec2(1, 1), silhouette->high() + Vec2(1, 1));
    if (range.x0 > range.x1 || range.y0 > range.y1) return;
    GhostRays rays(ghost, look.sunDirection.normalized(), hiding, range);
    for (int y = range.y0; y <= range.y1; ++y) {
        int begin = range.x0, end = range.x1 + 1;
        silhouette->columns(y, 0.5f, begin, end);
        int inner = begin, innerEnd = end;  // beyond the rim
        silhouette->columns(y, -0.5f - edge, inner, innerEnd);
        for (int x = begin; x < end; ++x) {
            const bool within = inner <= x && x < innerEnd;
            const float d = within ? -0.5f - edge : silhouette->distance(centreOf(x, y));
            const GhostPixel pixel = rays.at(x, y);
            if (pixel.seen == 0.0f) continue;
            const float inside = rays.hollow() ? 1.0f : std::clamp(0.5f - d, 0.0f, 1.0f);
            blend(image.at(x, y), tintOf(ghost.color, look, pixel, d, edge), pixel.seen * inside);
        }
    }
}

}  // namespace

void drawGhosts(Image& image, const Frame& frame, const View& view, const SurfaceMap& surfaces) {
    if (frame.ghosts.empty()) return;
    SeenSurfaces seen(frame, view, image.width, image.height);
    const Hiding hiding{surfaces, seen};
    for (const Solid& ghost : frame.ghosts) drawGhost(image, ghost, frame.look, view, hiding);
}

}  // namespace render
