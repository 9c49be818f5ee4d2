#include "demos/film/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/corners.h"

namespace demos {
namespace {

constexpr float kNarrow = 4.0f / 3.0f;       // width / height
constexpr std::size_t kTallPlate = 6;        // rows
constexpr float kPlateWidth = 15.0f;         // in letter heights
constexpr float kHalfSubject = 0.30f;        // of the width, on either side of the middle
constexpr float kWidestPlate = 0.5f;         // of the width: no room is left beside a wider one

/// Tangent of half the vertical angle of view.
float halfHeight(const render::Camera& camera) {
    return std::tan(camera.fovDegrees * std::numbers::pi_v<float> / 360.0f);
}

void keepWidth(float aspect, render::Camera& camera) {
    if (aspect >= kNarrow) return;
    const float half = halfHeight(camera) * kNarrow / aspect;
    camera.fovDegrees = std::min(std::atan(half) * 360.0f / std::numbers::pi_v<float>, 170.0f);
}

/// The width of a tall plate with its margin, as a share of the picture's; 0 without one.
float tallPlate(int width, int height, const render::Frame& frame) {
    for (const render::Plate& plate : frame.plates) {
        const bool right = plate.corner == render::Corner::topRight ||
                           plate.corner == render::Corner::bottomRight;
        if (!right || plate.rows.size() < kTallPlate) continue;
        const auto letters = static_cast<float>(render::textPixels(plate.size, frame.look, width, height));
        return (kPlateWidth * letters + render::cornerMargin(width, height)) /
               static_cast<float>(width);
    }
    return 0.0f;
}

}  // namespace

void fitCamera(int width, int height, render::Frame& frame) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    render::Camera& camera = frame.camera;
    keepWidth(aspect, camera);
    const float plate = tallPlate(width, height, frame);
    if (aspect < kNarrow || plate > kWidestPlate) return;  // there the subject is below it
    const float shift = std::max(kHalfSubject - (0.5f - plate), 0.0f);  // of the width
    const render::Vec3 sight = camera.lookAt - camera.from;
    const render::Vec3 right = sight.cross(camera.up).normalized();
    const render::Vec3 step = 2.0f * shift * aspect * halfHeight(camera) * sight.norm() * right;
    camera.from += step;
    camera.lookAt += step;
}

}  // namespace demos
