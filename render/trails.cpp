#include "render/trails.h"

namespace render {
namespace {

/// One pixel perpendicular to the band in the picture, in clip coordinates.
Eigen::Vector4f sideways(const Eigen::Vector4f& before, const Eigen::Vector4f& here,
                         const Eigen::Vector4f& after, int width, int height) {
    const float w = static_cast<float>(width), h = static_cast<float>(height);
    const Eigen::Vector2f from = before.head<2>() / before.w(), to = after.head<2>() / after.w();
    Eigen::Vector2f way((to.x() - from.x()) * w, (to.y() - from.y()) * h);
    if (way.norm() < 1e-6f) way = {1, 0};
    way.normalize();
    return Eigen::Vector4f(-way.y() * 2 / w, way.x() * 2 / h, 0, 0) * here.w();
}

/// Pixels of the picture per pixel of a trail: times / over.
struct TrailScale {
    float times, over;
};

void addBand(const Trail& trail, const View& view, int width, int height, const TrailScale& scale,
             std::vector<TrailVertex>& band) {
    std::vector<Eigen::Vector4f> clip;
    for (const Vec3& p : trail.points) clip.push_back(view.worldToClip() * p.homogeneous());
    const int n = static_cast<int>(clip.size());
    const auto vertices = [&](int i, TrailVertex (&pair)[2]) {
        const float age = static_cast<float>(i) / static_cast<float>(n - 1);  // 1: now
        const Eigen::Vector4f color(trail.color.r, trail.color.g, trail.color.b,
                                    trail.color.a * (0.04f + 0.9f * age * age));
        const Eigen::Vector4f pixel = sideways(clip[std::max(i - 1, 0)], clip[i],
                                               clip[std::min(i + 1, n - 1)], width, height);
        const float half =
            0.5f * trail.pixels * (0.35f + 0.65f * age) * scale.times / scale.over;
        const float reach = half + 0.5f;
        pair[0] = {clip[i] + reach * pixel, color, {reach, half}};
        pair[1] = {clip[i] - reach * pixel, color, {-reach, half}};
    };
    for (int i = 0; i + 1 < n; ++i) {
        if (clip[i].w() < view.nearest || clip[i + 1].w() < view.nearest) continue;
        TrailVertex a[2], b[2];
        vertices(i, a);
        vertices(i + 1, b);
        for (const TrailVertex& v : {a[0], a[1], b[0], b[0], a[1], b[1]}) band.push_back(v);
    }
}

}  // namespace

std::vector<TrailVertex> trailBands(const Frame& frame, const View& view, int width, int height) {
    std::vector<TrailVertex> band;
    const float unit = frame.look.unit;
    const TrailScale scale =
        unit > 0.0f ? TrailScale{unit, 1.0f} : TrailScale{static_cast<float>(height), 720.0f};
    for (const Trail& trail : frame.trails)
        if (trail.points.size() > 1) addBand(trail, view, width, height, scale, band);
    return band;
}

}  // namespace render
