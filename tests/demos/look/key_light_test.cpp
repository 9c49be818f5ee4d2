// The sun's direction relative to the camera.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "demos/look/key_light.h"
#include "demos/snapshot/camera.h"

namespace demos::test {
namespace {

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// deg, the angle between two directions seen from above; positive: the second is to the left.
double turnBetween(const engine::Vec3& a, const engine::Vec3& b) {
    const double cross = a.x() * b.z() - a.z() * b.x(), dot = a.x() * b.x() + a.z() * b.z();
    return degrees(std::atan2(cross, dot));
}

TEST(KeyLight, IsFiftyDegreesToTheLeftOfEveryCamera) {
    const engine::Vec3 lookAt(1, 2, 3);
    for (const engine::Vec3& sight : {engine::Vec3(0, 0, 10), engine::Vec3(-4, 7, 2),
                                      engine::Vec3(5, -1, -5), engine::Vec3(0.1, 30, 0)}) {
        const render::Vec3 light = keyLight(lookAt + sight, lookAt);
        EXPECT_NEAR(light.norm(), 1.0f, 1e-6f);
        EXPECT_NEAR(degrees(std::asin(static_cast<double>(light.y()))), 38.0, 1e-4);
        EXPECT_NEAR(turnBetween(sight, light.cast<double>()), 50.0, 1e-3);
    }
}

TEST(KeyLight, IsTheScenesOwnIfItHasOne) {
    SceneDescription scene;
    EXPECT_EQ(lightOf(scene), keyLight(scene.camera.from, scene.camera.lookAt));
    scene.look.light = Vec3(0, 3, 4);
    EXPECT_NEAR((lightOf(scene) - render::Vec3(0.0f, 0.6f, 0.8f)).norm(), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace demos::test
