#include "demos/mjcf/view.h"

#include "demos/scene/ranges.h"
#include "engine/base/trigonometry.h"
#include "engine/shape.h"

namespace demos::mjcf {
namespace {

constexpr Range kExtent{1e-3, 1e5, "m"};
constexpr double kLeastRadius = 0.02;  // m, of what the camera looks at
constexpr double kRoom = 0.85;         // share of that radius, which is generous, to be seen

struct Bounds {
    Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);

    void add(const Vec3& point, double reach) {
        low = low.cwiseMin(point - Vec3::Constant(reach));
        high = high.cwiseMax(point + Vec3::Constant(reach));
    }
    bool any() const { return low.x() <= high.x(); }
    Vec3 centre() const { return 0.5 * (low + high); }
    double radius() const { return 0.5 * (high - low).norm(); }
};

Bounds boundsOf(const SceneDescription& scene, engine::BodyKind kind) {
    Bounds bounds;
    for (const BodyDescription& body : scene.bodies)
        if (body.def.kind == kind && body.def.shape.type != engine::ShapeType::plane)
            bounds.add(body.def.pose.position, engine::reachOf(body.def.shape));
    return bounds;
}

/// Extends the bounds to a level floor that is not far below, so that falls end in the picture.
void addFloor(const SceneDescription& scene, Bounds& bounds) {
    const Vec3 centre = bounds.centre();
    const double far = 4.0 * bounds.radius();
    for (const BodyDescription& body : scene.bodies) {
        if (body.def.shape.type != engine::ShapeType::plane) continue;
        const double depth = bounds.low.y() - body.def.pose.position.y();
        const bool level = (body.def.pose.rotation * body.def.shape.normal).y() > 0.99;
        if (level && depth > 0.0 && depth < far)
            bounds.add({centre.x(), body.def.pose.position.y(), centre.z()}, 0.0);
    }
}

}  // namespace

CameraDescription readView(const Element& root, const Defaults& defaults,
                           const SceneDescription& scene) {
    Bounds bounds = boundsOf(scene, engine::BodyKind::dynamic);
    if (!bounds.any()) bounds = boundsOf(scene, engine::BodyKind::fixed);
    if (!bounds.any()) bounds.add(Vec3::Zero(), 1.0);
    addFloor(scene, bounds);
    Vec3 centre = bounds.centre();
    double radius = bounds.radius();
    CameraDescription camera;
    for (const Element& element : root.children) {
        if (element.name != "statistic") continue;
        Attributes attributes = defaults.of(element, "");
        const auto givenCentre = attributes.vector("center", kMeters);
        const auto givenExtent = attributes.number("extent", kExtent);
        if (givenCentre) centre = yUp(*givenCentre);
        if (givenExtent) radius = *givenExtent;
        camera.fitsMotion = !givenCentre && !givenExtent;
    }
    const double half = engine::radians(0.5 * camera.fovDegrees);
    const double away = kRoom * engine::larger(radius, kLeastRadius) / engine::sine(half);
    camera.lookAt = centre;
    camera.from = centre + away * Vec3(0.5, 0.32, 0.8).normalized();
    return camera;
}

}  // namespace demos::mjcf
