// The map has to cover what casts a shadow into the picture, and should not move: while it stays, the last
// picture can be kept. What a camera shows is about as large as d tan(fov / 2), d the distance of its
// subject. So the map lies around the subject, kWindows times as far to each side, for as long as that covers
// the casters. Otherwise it lies around these, in steps.
#include "render/shadow_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/solid_mesh.h"

namespace render {
namespace {

constexpr float kTooLarge = 40.0f;          // m: with such a table or floor, a brick gets one texel
constexpr float kApron = 4.0f;              // texels kept free around the casters
constexpr float kWindows[] = {1.3f, 1.8f};  // of the half height seen: at 1280x720 .37 and .51 pixels a texel
constexpr float kSmallest = 1e-4f;          // m
constexpr float kTooNear = 1 / 3.0f;        // of the subject's distance: there such texels are too wide

/// What casts shadows.
struct Caster {
    Eigen::AlignedBox3f box;  // m, in the light's axes
    Vec3 middle;              // m
    float radius;             // m, around the middle
};

/// Whether the caster or its shadow may be in the picture: any part of its way along the light, down to the
/// first ground, is on the inner side of all planes that bound the view.
bool reachesView(const Caster& caster, const Frame& frame, const Vec3& toLight,
                 const Eigen::Matrix4f& toClip) {
    constexpr float kSoft = 0.01f;  // of the subject's distance, for the soft edge of a shadow
    const float radius =
        caster.radius + kSoft * (frame.camera.from - frame.camera.lookAt).norm();
    float first = 0.0f, last = 1e5f;  // m, down from the caster
    for (const Ground& ground : frame.grounds) {
        const Vec3 normal = ground.normal.normalized();
        const float facing = normal.dot(toLight), height = normal.dot(caster.middle) - ground.offset;
        if (ground.visible && facing > 1e-3f && height > -radius)
            last = std::min(last, (height + radius) / facing);
    }
    const Eigen::Vector4f start = caster.middle.homogeneous();
    for (const auto& [axis, sign] : {std::pair(0, 1.0f), {0, -1.0f}, {1, 1.0f}, {1, -1.0f}, {2, 1.0f}}) {
        const Eigen::Vector4f plane = toClip.row(3) + sign * toClip.row(axis);
        const Vec3 inward = plane.head<3>();
        const float inside = plane.dot(start) + radius * inward.norm(), slope = -inward.dot(toLight);
        if (slope > 0.0f)
            first = std::max(first, -inside / slope);
        else if (slope < 0.0f)
            last = std::min(last, -inside / slope);
        else if (inside < 0.0f)
            return false;
    }
    return first <= last;
}

std::vector<Caster> castersOf(const Frame& frame, const Eigen::Matrix3f& axes) {
    std::vector<Caster> casters;
    for (const Solid& s : frame.solids) {
        const float core = s.shape == SolidShape::capsule ? s.halfSize.x() : 0.0f;
        const Vec3 half = s.shape == SolidShape::capsule ? s.halfSize : holdingHalfSize(s);
        const float radius = half.norm() + core;
        const float away = std::min((s.position - frame.camera.lookAt).norm(),
                                    (s.position - frame.camera.from).norm());
        if (radius <= kTooLarge && away <= 4 * kTooLarge)
            casters.push_back({lightBox(s, axes), s.position, radius});
    }
    for (const Rod& rod : frame.rods) {
        Eigen::AlignedBox3f box;
        for (const Vec3& end : {rod.from, rod.to}) {
            box.extend(Vec3(axes * end - Vec3::Constant(rod.radius)));
            box.extend(Vec3(axes * end + Vec3::Constant(rod.radius)));
        }
        casters.push_back({box, 0.5f * (rod.from + rod.to), 0.5f * (rod.to - rod.from).norm() + rod.radius});
    }
    return casters;
}

/// Rounds up to the next of `steps` in an octave.
float inSteps(float length, float steps) {
    return std::exp2(std::ceil(std::log2(std::max(length, 0.5f)) * steps) / steps);
}

/// Around the camera's subject; false if that is too small for the casters.
bool fitToView(const Eigen::AlignedBox3f& box, const Camera& camera, ShadowFit& fit, Vec3& middle) {
    const float angle = camera.fovDegrees * std::numbers::pi_v<float> / 360.0f;
    const float halfHeight =
        std::max((camera.from - camera.lookAt).norm() * std::tan(angle), kSmallest);
    for (const float window : kWindows) {
        fit.texel = 2.0f * window * halfHeight / static_cast<float>(fit.size - 2);
        fit.depth = 2.0f * window * halfHeight;
        middle = fit.worldToLight.block<3, 3>(0, 0) * camera.lookAt;
        for (int i = 0; i < 2; ++i) middle[i] = fit.texel * std::floor(middle[i] / fit.texel);
        if (box.isEmpty()) return true;
        const Vec3 reach = (box.max() - middle).cwiseMax(middle - box.min());
        if (std::max(reach.x(), reach.y()) < fit.half() - kApron * fit.texel) return true;
    }
    return false;
}

/// The map covers a quarter more than it needs, and its middle moves by a quarter of its size at a time, in
/// whole texels.
void fitToCasters(const Eigen::AlignedBox3f& box, ShadowFit& fit, Vec3& middle) {
    const Vec3 reach = 0.5f * box.sizes();
    const float widest = inSteps(std::max(reach.x(), reach.y()), 4.0f);
    const auto room = static_cast<float>(fit.size / 10);  // texels on each side
    fit.texel = 2.0f * widest / (static_cast<float>(fit.size) - 2.0f * (room + kApron + 1.0f));
    middle = box.center();
    for (int i = 0; i < 2; ++i)
        middle[i] = fit.texel * (std::floor(middle[i] / (2.0f * room * fit.texel)) * 2.0f * room + room);
    const float step = inSteps(reach.z(), 1.0f) + widest;
    fit.depth = 1.5f * step;  // also room for receivers a little beyond
    middle.z() = (std::floor(middle.z() / step) + 0.5f) * step;
}

}  // namespace

Eigen::AlignedBox3f lightBox(const Solid& solid, const Eigen::Matrix3f& toLight) {
    const bool capsule = solid.shape == SolidShape::capsule;
    const float core = capsule ? solid.halfSize.x() : 0.0f;
    const Vec3 half = capsule ? solid.halfSize : holdingHalfSize(solid);
    const Eigen::Matrix3f axes = toLight * solid.rotation.toRotationMatrix();
    const Vec3 reach = solid.shape == SolidShape::sphere ? half : Vec3(axes.cwiseAbs() * half);
    const Vec3 middle = toLight * solid.position;
    return {Vec3(middle - reach - Vec3::Constant(core)),
            Vec3(middle + reach + Vec3::Constant(core))};
}

Eigen::Matrix4f ShadowFit::worldToTexels() const {
    Eigen::Matrix4f toTexels = Eigen::Matrix4f::Identity();
    toTexels(0, 0) = toTexels(1, 1) = 1.0f / texel;
    toTexels(0, 3) = toTexels(1, 3) = 0.5f * static_cast<float>(size);
    toTexels(2, 2) = -0.5f / depth;
    toTexels(2, 3) = 0.5f;
    return toTexels * worldToLight;
}

bool ShadowFit::operator==(const ShadowFit& other) const {
    return toLight == other.toLight && worldToLight == other.worldToLight && texel == other.texel &&
           depth == other.depth && size == other.size;
}

ShadowFit fitShadow(const Frame& frame, const View& view, const Vec3& toLight, int size) {
    ShadowFit fit;
    fit.size = size;
    fit.toLight = toLight.normalized();
    fit.worldToLight = lookAt(fit.toLight, Vec3::Zero(), Vec3::UnitY());
    fit.worldToLight.block<3, 1>(0, 3).setZero();
    const Eigen::Matrix4f toClip = view.worldToClip();
    const float near = kTooNear * (frame.camera.from - frame.camera.lookAt).norm();
    Eigen::AlignedBox3f box;
    bool isNear = false;
    for (const Caster& caster : castersOf(frame, fit.worldToLight.block<3, 3>(0, 0))) {
        if (!reachesView(caster, frame, fit.toLight, toClip)) continue;
        box.extend(caster.box);
        isNear = isNear || toClip.row(3).dot(caster.middle.homogeneous()) < near;
    }
    Vec3 middle;
    if (isNear || !fitToView(box, frame.camera, fit, middle)) fitToCasters(box, fit, middle);
    if (!box.isEmpty())
        while (fit.depth < std::max(box.max().z() - middle.z(), middle.z() - box.min().z()))
            fit.depth *= 2.0f;
    fit.worldToLight.block<3, 1>(0, 3) = -middle;
    return fit;
}

}  // namespace render
