// light = (sin b cos h, sin h, cos b cos h),   b = atan2(c_x, c_z) - 50 deg,   c = from - lookAt
#include "demos/look/key_light.h"

#include <cmath>
#include <numbers>

namespace demos {
namespace {

constexpr double kAside = 50.0 * std::numbers::pi / 180.0;  // rad
constexpr double kAbove = 38.0 * std::numbers::pi / 180.0;  // rad

}  // namespace

render::Vec3 keyLight(const engine::Vec3& from, const engine::Vec3& lookAt) {
    const engine::Vec3 camera = from - lookAt;
    const double bearing = std::atan2(camera.x(), camera.z()) - kAside;
    const engine::Vec3 light(std::sin(bearing) * std::cos(kAbove), std::sin(kAbove),
                             std::cos(bearing) * std::cos(kAbove));
    return light.cast<float>();
}

}  // namespace demos
